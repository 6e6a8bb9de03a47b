# What the search is built from; against the real rules here, against others elsewhere.
set(WELLS_SEARCH_SOURCES
    ${CMAKE_CURRENT_LIST_DIR}/group.cpp ${CMAKE_CURRENT_LIST_DIR}/groups.cpp ${CMAKE_CURRENT_LIST_DIR}/healing.cpp
    ${CMAKE_CURRENT_LIST_DIR}/knowledge.cpp ${CMAKE_CURRENT_LIST_DIR}/model.cpp ${CMAKE_CURRENT_LIST_DIR}/model_acts.cpp ${CMAKE_CURRENT_LIST_DIR}/model_checks.cpp
    ${CMAKE_CURRENT_LIST_DIR}/search.cpp ${CMAKE_CURRENT_LIST_DIR}/trace.cpp)
