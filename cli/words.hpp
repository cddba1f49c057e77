// The words of a command line before they are options: which are numbers, and which a verb may take.
#pragma once

#include <string>
#include <vector>

namespace tribunal::cli {

/// The numbers of `tribunal sign`, taken out of the arguments before options are looked for: "-1" is a
/// coordinate. Of other verbs none are taken.
std::vector<std::string> take_numbers(std::vector<std::string>& words);

// Each of these is empty where the text is good, else it says why not: what a parser of options wants.

/// Whole numbers are what they look like: libraries would read 010 as 8 and -1 as 2^64 - 1.
std::string check_whole_number(const std::string& text);
/// A time to wait: more than nothing, and less than what clocks can count.
std::string check_seconds(const std::string& text);
/// An empty word where a name is wanted is a script's unset variable.
std::string check_not_empty(const std::string& text);

}  // namespace tribunal::cli
