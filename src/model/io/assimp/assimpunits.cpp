#include "model/io/assimp/assimpunits.h"

#include "model/io/files/unzipping.h"

#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>
#include <utility>

namespace autocuts {

namespace {

//! Of a file.
struct FileUnits
{
    double metres = 1; //!< in a unit
    bool zUp = true;
};

//! What a file says of its unit stands within this many bytes.
constexpr std::size_t unitHeadSize = std::size_t(1) << 16;

std::string bytesOf(const std::string &path, std::size_t most)
{
    std::ifstream file(path, std::ios::binary);
    std::string bytes(std::min(most, std::size_t(std::filesystem::file_size(path))), '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

std::string headOf(const std::string &path)
{
    return bytesOf(path, unitHeadSize);
}

//! The begin of the model in a 3MF package.
std::string modelHeadOf(const std::string &path)
{
    return beginInArchive(bytesOf(path, std::numeric_limits<std::size_t>::max()), ".model", unitHeadSize);
}

//! What stands between quotation marks or braces behind a word, or nothing.
std::string_view valueBehind(std::string_view text, std::string_view word, std::string_view marks)
{
    const std::size_t at = text.find(word);
    const std::size_t begin = at == std::string_view::npos ? at : text.find_first_of(marks, at + word.size());
    const std::size_t end = begin == std::string_view::npos ? begin : text.find_first_of(marks, begin + 1);
    return end == std::string_view::npos ? std::string_view() : text.substr(begin + 1, end - begin - 1);
}

//! Of the units that 3MF and AMF files can have.
FileUnits namedUnits(const std::string &head, std::string_view tag)
{
    constexpr std::array<std::pair<std::string_view, double>, 7> known{{{"micron", 1e-6},
                                                                        {"centimeter", 0.01},
                                                                        {"inch", 0.0254},
                                                                        {"foot", 0.3048},
                                                                        {"feet", 0.3048},
                                                                        {"meter", 1},
                                                                        {"millimeter", 0.001}}};
    std::string_view root = head;
    root.remove_prefix(std::min(root.find(tag), root.size()));
    const std::string_view name = valueBehind(root.substr(0, root.find('>')), " unit", "\"'");
    for (const auto &[unit, metres] : known) {
        if (unit == name)
            return {metres};
    }
    return {0.001};
}

FileUnits metricsOf(std::string_view head)
{
    const auto metric = [head](std::string_view name) {
        const std::size_t at = head.find(name);
        const std::size_t type = at == std::string_view::npos ? at : head.find('{', at);
        return type == std::string_view::npos ? std::string_view() : head.substr(type + 1);
    };
    FileUnits units;
    const double metres = std::atof(std::string(valueBehind(metric("\"distance\""), "float", "{}")).c_str());
    if (metres > 0)
        units.metres = metres;
    units.zUp = valueBehind(metric("\"up\""), "string", "\"") != "y";
    return units;
}

FileUnits unitsOf(const std::string &suffix, const std::string &path)
{
    if (suffix == "3mf")
        return namedUnits(modelHeadOf(path), "<model");
    if (suffix == "amf")
        return namedUnits(headOf(path), "<amf");
    if (suffix == "ogex")
        return metricsOf(headOf(path));
    return {1, suffix == "cob" || suffix == "smd" || suffix == "hmp"};
}

} // namespace

void completeUnits(aiScene &scene, const std::string &suffix, const std::string &path)
{
    const FileUnits units = unitsOf(suffix, path);
    const auto s = static_cast<ai_real>(units.metres);
    const aiMatrix4x4 yUp(s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0, 0, 0, 0, 1);
    const aiMatrix4x4 zUp(s, 0, 0, 0, 0, 0, s, 0, 0, -s, 0, 0, 0, 0, 0, 1);
    if (units.zUp || units.metres != 1)
        scene.mRootNode->mTransformation = (units.zUp ? zUp : yUp) * scene.mRootNode->mTransformation;
}

} // namespace autocuts
