#include <shell_origami/base/bounded_json.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace shell_origami {
namespace {

using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

template <class Call>
std::string rejection(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Lists within lists.
Json nested(int depth) {
  Json value = 1;
  for (int i = 0; i < depth; ++i) value = Json::array({std::move(value)});
  return value;
}

TEST(BoundedJson, readsWhatNestsNoDeeperThanItsBound) {
  const Json deepest = nested(kDeepestJson), deeper = nested(kDeepestJson + 1);
  EXPECT_EQ(parseJson(deepest.dump()), deepest);
  EXPECT_EQ(parseCbor(Json::to_cbor(deepest)), deepest);
  const std::string sentence = "its lists and objects nest deeper than 100 levels";
  EXPECT_EQ(rejection([&] { parseJson(deeper.dump()); }), sentence);
  EXPECT_EQ(rejection([&] { parseCbor(Json::to_cbor(deeper)); }), sentence);
}

TEST(BoundedJson, aMillionLevelsTakeNoStack) {
  constexpr std::size_t kLevels = 1000000;
  const auto is_deep = [](const std::string& sentence) {
    return sentence.find("nest deeper") != std::string::npos;
  };
  EXPECT_TRUE(is_deep(rejection([&] { parseJson(std::string(kLevels, '[')); })));
  std::string objects;
  for (std::size_t i = 0; i < kLevels; ++i) objects += "{\"a\":";
  EXPECT_TRUE(is_deep(rejection([&] { parseJson(objects); })));
  EXPECT_TRUE(is_deep(rejection([&] { parseCbor(Bytes(kLevels, 0x81)); })));
  EXPECT_TRUE(is_deep(rejection([&] { parseCbor(Bytes(kLevels, 0xa1)); })));
  // Lists, maps, texts and bytes of indefinite length: nlohmann's reader recurses for each.
  for (const int byte : {0x9f, 0xbf, 0x7f, 0x5f}) {
    EXPECT_EQ(rejection([&] { parseCbor(Bytes(kLevels, static_cast<std::uint8_t>(byte))); }),
              "it holds a CBOR item of indefinite length");
  }
}

TEST(BoundedJson, cborKeepsEveryKindOfValue) {
  const Json value = {{"list", {1, -7, 300, -70000, 5000000000, 1.5, 1e300, true, nullptr}},
                      {"text", std::string(300, 'x')},
                      {"empty", {Json::array(), Json::object(), ""}},
                      {"lists", std::vector<std::vector<int>>(300, std::vector<int>(30, 4))}};
  EXPECT_EQ(parseCbor(Json::to_cbor(value)), value);
}

TEST(BoundedJson, saysWhatIsNotCbor) {
  Bytes bytes = Json::to_cbor({{"a", {1, 2, 3}}});
  bytes.pop_back();
  EXPECT_EQ(rejection([&] { parseCbor(bytes); }).rfind("it is not CBOR: ", 0), 0u);
  EXPECT_EQ(rejection([&] { parseCbor({}); }).rfind("it is not CBOR: ", 0), 0u);
  // A list that claims 2^64 - 1 items, and a map that claims as many.
  for (const int kind : {0x9b, 0xbb}) {
    const Bytes claims{static_cast<std::uint8_t>(kind), 255, 255, 255, 255, 255, 255, 255, 255};
    EXPECT_EQ(rejection([&] { parseCbor(claims); }).rfind("it is not CBOR: ", 0), 0u) << kind;
  }
}

TEST(BoundedJson, namesTheLineThatIsNotJson) {
  EXPECT_EQ(rejection([] {
              parseJson("{\"a\": 1,\n\n \"b\": nope}");
            }).rfind("is not JSON from line 3", 0),
            0u);
  EXPECT_EQ(rejection([] { parseJson("1e999"); }),
            "is not JSON that can be read: a number is out of range");
}

TEST(BoundedJson, describesContainersByTheirSize) {
  EXPECT_EQ(describeJson(nested(3)), "a list of 1");
  EXPECT_EQ(describeJson({{"a", 1}, {"b", 2}}), "an object of 2 entries");
  EXPECT_EQ(describeJson("word"), "\"word\"");
  EXPECT_EQ(describeJson(nullptr), "null");
  EXPECT_EQ(describeJson(std::string(100, 'x')), "\"" + std::string(56, 'x') + "...");
  EXPECT_NO_THROW(describeJson("\xff"));
}

}  // namespace
}  // namespace shell_origami
