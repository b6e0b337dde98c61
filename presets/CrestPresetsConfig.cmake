# find_package(CrestPresets) brings Crest::presets: read, write and evaluate presets, find their peaks, exchange them.
include(CMakeFindDependencyMacro)
find_dependency(glm)
find_dependency(nlohmann_json)
find_dependency(fmt)
find_dependency(pugixml)
find_dependency(ZLIB)
include(${CMAKE_CURRENT_LIST_DIR}/CrestPresetsTargets.cmake)
