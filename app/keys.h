// The one definition of every config key. The config file, the command line, the help, the README's
// table and the world's canonical text all come from it.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config.h"

namespace wells {

/// Whom a key concerns.
enum class Scope {
  World,     // the same for all peers of a session; part of its canonical text
  Peer,      // each peer's own
  Transport  // of the old client-server transport: accepted, not used
};

struct Key {
  enum class Repeat { No, Yes };

  std::string name;
  std::string group{};  // heading in the help
  std::string unit{};   // "" for a pure number or a word
  std::string allowed;  // what a value may be, for messages and tables
  std::string help;
  Scope scope = Scope::Peer;
  Repeat repeat = Repeat::No;

  /// Takes a value; a relative file name is relative to `base`. Throws BadValue.
  std::function<void(Config&, std::string_view value, const std::filesystem::path& base)> set;

  /// The value as text that `set` takes, once for each repeat; empty where the config has none.
  std::function<std::vector<std::string>(const Config&)> get;

  /// Of a key that may be repeated: forgets the values so far.
  std::function<void(Config&)> clear{};

  /// What holds when the key is absent, where get() of a default Config doesn't tell.
  std::string absent = "none";

  /// For help and tables.
  std::string defaultText() const;
};

/// In the order of help, tables and canonical text.
std::span<const Key> keys();

/// nullptr: no such key. Case counts.
const Key* findKey(std::string_view name);

/// "did you mean BallRadius?" or "".
std::string suggestKey(std::string_view name);

/// The table as Markdown, for the README.
std::string keysAsMarkdown();

}  // namespace wells
