#include "test/fuzz/mutate.h"

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace shell_origami {
namespace {

using Json = nlohmann::json;

Json oddValue(RandomSheets& random) {
  static const std::vector<Json> kOdd = {nullptr,
                                         true,
                                         0,
                                         1,
                                         -1,
                                         2,
                                         7,
                                         1e308,
                                         -1e308,
                                         1e-320,
                                         0.1,
                                         180,
                                         -180,
                                         4294967295u,
                                         std::numeric_limits<std::int64_t>::min(),
                                         std::numeric_limits<std::uint64_t>::max(),
                                         "",
                                         "B",
                                         "M",
                                         "all",
                                         "m",
                                         "foldedForm",
                                         std::string(200, 'x'),
                                         Json::array(),
                                         Json::object(),
                                         Json::array({0, 1}),
                                         Json::array({0, 1, 2}),
                                         Json::array({0.5, 0.5})};
  return kOdd[random.below(static_cast<int>(kOdd.size()))];
}

/// A value somewhere in the document: each level down is as likely to be the last as not.
Json& somewhere(Json& document, RandomSheets& random) {
  Json* place = &document;
  while (place->is_structured() && !place->empty() && (place == &document || random.below(4) > 0)) {
    auto item = place->begin();
    std::advance(item, random.below(static_cast<int>(place->size())));
    place = &*item;
  }
  return *place;
}

void change(Json& document, RandomSheets& random) {
  Json& place = somewhere(document, random);
  switch (random.below(6)) {
    case 0: place = oddValue(random); break;
    case 1:
      if (place.is_number()) place = place.get<double>() * random.between(-2, 2);
      else place = oddValue(random);
      break;
    case 2: {
      const Json other = somewhere(document, random);
      somewhere(document, random) = other;
      break;
    }
    case 3: {
      Json deep = place;
      for (int depth = random.below(200); depth > 0; --depth) deep = Json::array({std::move(deep)});
      place = std::move(deep);
      break;
    }
    case 4:
      if (place.is_array() && !place.empty()) place.push_back(place[0]);
      break;
    default:
      if (place.is_structured() && !place.empty()) {
        auto item = place.begin();
        std::advance(item, random.below(static_cast<int>(place.size())));
        place.erase(item);
      }
  }
}

}  // namespace

void mutate(Json& document, RandomSheets& random) {
  for (int changes = 1 + random.below(3); changes > 0; --changes) change(document, random);
}

void mutate(std::string& bytes, RandomSheets& random) {
  for (int changes = 1 + random.below(4); changes > 0 && !bytes.empty(); --changes) {
    const auto at = static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())));
    const std::size_t length = 1 + static_cast<std::size_t>(random.below(8));
    switch (random.below(5)) {
      case 0: bytes[at] = static_cast<char>(random.below(256)); break;
      case 1: bytes.erase(at, length); break;
      case 2: bytes.insert(at, bytes.substr(at, length)); break;
      case 3: {
        static const std::string kMarks = "[]{},:\"-.e019\x7f\x5f\x9f\xbf\xff\x81\xa1";
        const auto mark = static_cast<std::size_t>(random.below(static_cast<int>(kMarks.size())));
        bytes.insert(at, random.below(20) == 0 ? 100000 : length, kMarks[mark]);
        break;
      }
      default: bytes.resize(at);
    }
  }
}

}  // namespace shell_origami
