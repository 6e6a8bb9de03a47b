def table_of(recorded, reports, relayed, lost):
    import json
    text=relayed+"lost %d\n"%lost
    for r in reports:
        text += json.dumps({k:v for k,v in r.items() if k not in("books",)})+"\n"
    return text
