#include "test/fuzz/fuzz.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

int main(int argc, char** argv) {
  using namespace shell_origami;
  const unsigned seed = argc == 4 ? static_cast<unsigned>(std::atoi(argv[3])) : 1;
  const int count = argc >= 3 ? std::atoi(argv[2]) : 0;
  if (count > 0 && argc <= 4 && std::strcmp(argv[1], "folds") == 0) {
    return fuzzFolds(count, seed) ? 0 : 1;
  }
  if (count > 0 && argc <= 4 && std::strcmp(argv[1], "recipes") == 0) {
    return fuzzRecipes(count, seed) ? 0 : 1;
  }
  std::fprintf(stderr, "usage: %s folds|recipes COUNT [SEED]\n", argv[0]);
  return 2;
}
