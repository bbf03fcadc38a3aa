#include "test/fuzz/fuzz.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

int main(int argc, char** argv) {
  using namespace shell_origami;
  const std::map<std::string, bool (*)(int, unsigned)> kinds = {
      {"folds", fuzzFolds},         {"recipes", fuzzRecipes},
      {"fold_text", fuzzFoldText},  {"cbor", fuzzCbor},
      {"edits", fuzzEdits},         {"patterns", fuzzPatterns},
      {"obstacles", fuzzObstacles}, {"folds_through", fuzzFoldsThrough}};
  const auto kind = argc >= 3 && argc <= 4 ? kinds.find(argv[1]) : kinds.end();
  const int count = argc >= 3 ? std::atoi(argv[2]) : 0;
  const unsigned seed = argc == 4 ? static_cast<unsigned>(std::atoi(argv[3])) : 1;
  if (kind != kinds.end() && count > 0) return kind->second(count, seed) ? 0 : 1;
  std::fprintf(stderr,
               "usage: %s "
               "folds|folds_through|recipes|fold_text|cbor|edits|patterns|obstacles COUNT [SEED]\n",
               argv[0]);
  return 2;
}
