// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/expected.h"

namespace tzc::rewriter {

/// A direct child of a document's root element, with its place: enough of XML to edit a package.xml as text.
struct XmlElement {
  std::string name, attributes;
  std::string text;       ///< trimmed
  std::size_t begin = 0;  ///< of '<'
  std::size_t end = 0;    ///< after the closing tag's '>'
};

struct XmlDocument {
  std::string root;
  std::string root_attributes;
  std::vector<XmlElement> children;
  std::size_t root_close = 0;  ///< offset of the root's closing tag
};

/// Comments, CDATA, processing instructions and nested elements are passed over, never matched.
Expected<XmlDocument> scan_xml(std::string_view content, const std::string& path);

/// The value of an attribute, in either kind of quotes; empty when there is none.
std::string xml_attribute(const std::string& attributes, const std::string& name);

}  // namespace tzc::rewriter
