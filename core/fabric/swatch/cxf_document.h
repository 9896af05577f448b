#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace loomlight {

/// A CxF file, read as XML. Entities of its own, external ones among them, are not followed.
class CxfDocument {
 public:
  /// Throws InputError, naming `source` and the place, for what is no XML or no CxF.
  CxfDocument(std::string_view text, const std::string& source);
  const pugi::xml_document& document() const { return document_; }

 private:
  pugi::xml_document document_;
};

/// All elements below a node of a name without the prefix of its namespace, in the order of the file; of an empty name
/// all there are.
std::vector<pugi::xml_node> cxfNamed(const pugi::xml_node& node, std::string_view name);

/// What an Object is called: its Name, or else its Id.
std::string cxfName(const pugi::xml_node& object);

/// Takes the next word off a list between blanks; empty at its end.
std::string_view cxfWord(std::string_view& list);

}  // namespace loomlight
