// Text that came from outside, made harmless inside HTML.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace tribunal::reports {

/// For element content and double-quoted attributes: & < > " ' become references; bytes that are no UTF-8 and
/// control characters become U+FFFD.
std::string escape(std::string_view text);

/// JSON for the inside of a <script> element: no "<" is left that could end it.
std::string script_json(const nlohmann::json& json);

/// A name as an HTML id: letters, digits and "-", everything else "-".
std::string html_id(std::string_view name);

}  // namespace tribunal::reports
