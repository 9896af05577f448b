#include "core/fabric/swatch/cxf_document.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/fabric/model/field_path.h"

namespace loomlight {
namespace {

std::string_view localName(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name.substr(name.find(':') + 1);
}

/// The node after this one in the order of the file, below `top`; without recursion, for files nest as deep as they
/// like.
pugi::xml_node following(pugi::xml_node node, const pugi::xml_node& top) {
  if (const pugi::xml_node child = node.first_child()) return child;
  while (node && node != top) {
    if (const pugi::xml_node next = node.next_sibling()) return next;
    node = node.parent();
  }
  return {};
}

/// Deeper than any file of colours nests, and so little that a search within each of nested elements stays short.
constexpr int kMostDeep = 64;

bool isDeeperThan(const pugi::xml_document& document, int most) {
  int depth = 0;
  pugi::xml_node node = document;
  for (;;) {
    if (const pugi::xml_node child = node.first_child()) {
      node = child;
      if (++depth > most) return true;
      continue;
    }
    while (node != document && !node.next_sibling()) {
      node = node.parent();
      --depth;
    }
    if (node == document) return false;
    node = node.next_sibling();
  }
}

}  // namespace

CxfDocument::CxfDocument(std::string_view text, const std::string& source) {
  const pugi::xml_parse_result result =
      document_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    const auto end = text.begin() + std::min(result.offset, static_cast<ptrdiff_t>(text.size()));
    throw InputError(fmt::format("{}: line {}: expected XML of CxF: {}", source,
                                 1 + std::count(text.begin(), end, '\n'), result.description()));
  }
  if (isDeeperThan(document_, kMostDeep))
    throw InputError(fmt::format("{}: expected elements within elements at most {} deep", source, kMostDeep));
  if (localName(document_.document_element()) != "CxF")
    throw InputError(fmt::format("{}: expected CxF, an XML file whose outermost element is CxF; it is \"{}\"", source,
                                 plainText(document_.document_element().name())));
}

std::vector<pugi::xml_node> cxfNamed(const pugi::xml_node& node, std::string_view name) {
  std::vector<pugi::xml_node> found;
  for (pugi::xml_node each = following(node, node); each; each = following(each, node))
    if (each.type() == pugi::node_element && (name.empty() || localName(each) == name)) found.push_back(each);
  return found;
}

std::string cxfName(const pugi::xml_node& object) {
  const std::string name = object.attribute("Name").value();
  return name.empty() ? object.attribute("Id").value() : name;
}

std::string_view cxfWord(std::string_view& list) {
  constexpr std::string_view kBlanks = " \t\r\n";
  list.remove_prefix(std::min(list.find_first_not_of(kBlanks), list.size()));
  const std::string_view word = list.substr(0, list.find_first_of(kBlanks));
  list.remove_prefix(word.size());
  return word;
}

}  // namespace loomlight
