// Decompresses files, in the reader.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace autocuts {

//! What is in a stream of zlib or gzip. Empty when it is damaged.
std::string unzipped(std::string_view packed);

//! The begin of the first file in a zip archive whose name has this ending. Empty when there is none, or the
//! archive is damaged. \param most bytes
std::string beginInArchive(std::string_view archive, std::string_view ending, std::size_t most);

} // namespace autocuts
