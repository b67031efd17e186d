#include "model/io/collada/colladamesh.h"

#include "model/io/assimp/assimpsource.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>

namespace autocuts {

namespace {

constexpr int maxOffset = 100;

template <typename T>
bool parsed(std::string_view word, T &value)
{
    if (word.starts_with('+'))
        word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

//! Calls add(word) for the words of a text; false when one of the calls is.
template <typename Add>
bool eachWord(std::string_view text, const Add &add)
{
    constexpr std::string_view space = " \t\r\n";
    for (std::size_t at = text.find_first_not_of(space); at != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(space, at), text.size());
        if (!add(text.substr(at, end - at)))
            return false;
        at = text.find_first_not_of(space, end);
    }
    return true;
}

//! A whole number in an attribute, or the default when it is missing; false when it is something else.
bool numberOf(const XmlElement &element, std::string_view key, int otherwise, int &value)
{
    value = otherwise;
    const std::string_view text = element.attribute(key);
    return text.empty() || (parsed(text, value) && value >= 0);
}

bool readInput(const XmlElement &element, ColladaInput &input)
{
    input.element = &element;
    input.semantic = element.attribute("semantic");
    input.source = element.attribute("source");
    if (!input.source.starts_with('#') || !numberOf(element, "offset", 0, input.offset) ||
        !numberOf(element, "set", 0, input.set) || input.offset > maxOffset || input.set >= maxAssimpUvSets)
        return false;
    input.source.remove_prefix(1);
    return true;
}

bool readIndices(const XmlElement &p, ColladaPrimitive &primitive)
{
    return p.children.empty() && eachWord(p.content, [&](std::string_view word) {
               int index = -1;
               if (!parsed(word, index) || index < 0)
                   return false;
               primitive.words.push_back(word);
               primitive.indices.push_back(index);
               return true;
           });
}

bool readFaces(const XmlElement &element, ColladaPrimitive &primitive)
{
    const auto stride = static_cast<std::size_t>(primitive.stride);
    for (const XmlElement &child : element.children) {
        if (child.name == "ph")
            return false;
        const std::size_t before = primitive.indices.size();
        if (child.name == "p" && !readIndices(child, primitive))
            return false;
        if (child.name == "p" && element.name == "polygons")
            primitive.faceSizes.push_back(static_cast<int>((primitive.indices.size() - before) / stride));
        const auto addSize = [&](std::string_view word) {
            int size = 0;
            const bool fine = parsed(word, size) && size > 0;
            primitive.faceSizes.push_back(size);
            return fine;
        };
        if (child.name == "vcount" && !eachWord(child.content, addSize))
            return false;
    }
    if (element.name == "triangles")
        primitive.faceSizes.assign(primitive.indices.size() / stride / 3, 3);
    std::size_t corners = 0;
    for (const int size : primitive.faceSizes)
        corners += static_cast<std::size_t>(size);
    return corners * stride == primitive.indices.size();
}

//! The inputs among the children of an element; false when one is damaged.
bool readInputs(const XmlElement &element, std::vector<ColladaInput> &inputs)
{
    for (const XmlElement &child : element.children) {
        if (child.name != "input")
            continue;
        inputs.emplace_back();
        if (!readInput(child, inputs.back()))
            return false;
    }
    return true;
}

bool readPrimitive(const XmlElement &element, const std::vector<ColladaInput> &ofVertices,
                   ColladaPrimitive &primitive)
{
    primitive.element = &element;
    if (!readInputs(element, primitive.inputs))
        return false;
    const auto vertex = std::find_if(primitive.inputs.begin(), primitive.inputs.end(),
                                     [](const ColladaInput &input) { return input.semantic == "VERTEX"; });
    if (vertex == primitive.inputs.end())
        return false;
    const int vertexOffset = vertex->offset;
    for (ColladaInput input : ofVertices) {
        input.offset = vertexOffset;
        input.inVertices = true;
        if (input.semantic == "TEXCOORD")
            primitive.inputs.push_back(input);
    }
    std::set<int> sets;
    for (const ColladaInput &input : primitive.inputs) {
        if (input.semantic == "TEXCOORD" && !sets.insert(input.set).second)
            return false;
        primitive.stride = std::max(primitive.stride, input.offset + 1);
    }
    return readFaces(element, primitive);
}

bool readGeometry(const XmlElement &element, ColladaGeometry &geometry)
{
    geometry.id = resolved(element.attribute("id"));
    geometry.name = resolved(element.attribute("name"));
    geometry.mesh = element.child("mesh");
    if (!geometry.mesh)
        return true;
    geometry.vertices = geometry.mesh->child("vertices");
    std::vector<ColladaInput> ofVertices;
    if (geometry.vertices && !readInputs(*geometry.vertices, ofVertices))
        return false;
    for (const XmlElement &child : geometry.mesh->children) {
        if (child.name == "tristrips" || child.name == "trifans")
            return false;
        if (child.name != "triangles" && child.name != "polylist" && child.name != "polygons")
            continue;
        geometry.primitives.emplace_back();
        if (!readPrimitive(child, ofVertices, geometry.primitives.back()))
            return false;
    }
    return geometry.vertices || geometry.primitives.empty();
}

bool readNumbers(const XmlElement &source, ColladaNumbers &numbers)
{
    numbers.source = &source;
    numbers.array = source.child("float_array");
    const XmlElement *technique = source.child("technique_common");
    numbers.accessor = technique ? technique->child("accessor") : nullptr;
    if (!numbers.array || !numbers.accessor)
        return true; // names, for example; those who need numbers check for them
    int offset = 0, count = 0;
    if (!numberOf(*numbers.accessor, "stride", 1, numbers.stride) || numbers.stride < 1 ||
        !numberOf(*numbers.accessor, "offset", 0, offset) || !numberOf(*numbers.accessor, "count", 0, count))
        return false;
    const bool fine = eachWord(numbers.array->content, [&](std::string_view word) {
        numbers.values.push_back(0);
        return parsed(word, numbers.values.back());
    });
    const std::string_view array = numbers.accessor->attribute("source");
    numbers.isPlain = offset == 0 && numbers.stride >= 2 && array.starts_with('#') &&
                      array.substr(1) == numbers.array->attribute("id") && count == numbers.rows() &&
                      count * numbers.stride == static_cast<int>(numbers.values.size()) &&
                      numbers.array->children.empty();
    // Elements that begin elsewhere are not needed here.
    return fine && offset == 0;
}

bool readSources(const XmlElement &element, std::map<std::string_view, ColladaNumbers> &sources)
{
    for (const XmlElement &child : element.children) {
        if (child.name != "source")
            continue;
        const auto [place, isNew] = sources.try_emplace(child.attribute("id"));
        if (!isNew || !readNumbers(child, place->second))
            return false;
    }
    return true;
}

//! True when all indices of texture coordinates are rows of their source.
bool hasGoodTexcoords(const ColladaFile &file, const ColladaPrimitive &primitive)
{
    return std::all_of(primitive.inputs.begin(), primitive.inputs.end(), [&](const ColladaInput &input) {
        if (input.semantic != "TEXCOORD")
            return true;
        const auto numbers = file.sources.find(input.source);
        if (numbers == file.sources.end() || numbers->second.stride < 2)
            return false;
        for (std::size_t i = static_cast<std::size_t>(input.offset); i < primitive.indices.size();
             i += static_cast<std::size_t>(primitive.stride)) {
            if (primitive.indices[i] >= numbers->second.rows())
                return false;
        }
        return true;
    });
}

} // namespace

const ColladaInput *ColladaPrimitive::texcoord(int set) const
{
    const auto found = std::find_if(inputs.begin(), inputs.end(), [set](const ColladaInput &input) {
        return input.semantic == "TEXCOORD" && input.set == set;
    });
    return found == inputs.end() ? nullptr : &*found;
}

//! Assimp gives all primitives of a geometry one list for each set; it fills the list up with zeros when a
//! later primitive has the set.
std::vector<int> ColladaGeometry::setsOf(std::size_t primitive) const
{
    std::set<int> sets;
    for (std::size_t p = primitive; p < primitives.size(); ++p) {
        for (const ColladaInput &input : primitives[p].inputs) {
            if (input.semantic == "TEXCOORD")
                sets.insert(input.set);
        }
    }
    return {sets.begin(), sets.end()};
}

std::optional<ColladaFile> readCollada(std::string_view text)
{
    std::optional<XmlElement> root = xmlSpans(text);
    if (!root || root->name != "COLLADA")
        return {};
    ColladaFile file;
    file.root = std::move(*root);
    std::set<std::string> ids;
    for (const XmlElement &library : file.root.children) {
        if (library.name != "library_geometries")
            continue;
        for (const XmlElement &element : library.children) {
            if (element.name != "geometry")
                continue;
            file.geometries.emplace_back();
            ColladaGeometry &geometry = file.geometries.back();
            if (!readGeometry(element, geometry) || !ids.insert(geometry.id).second ||
                (geometry.mesh && !readSources(*geometry.mesh, file.sources)))
                return {};
        }
    }
    for (const ColladaGeometry &geometry : file.geometries) {
        for (const ColladaPrimitive &primitive : geometry.primitives) {
            if (!hasGoodTexcoords(file, primitive))
                return {};
        }
    }
    return file;
}

std::vector<Vec3> positionsOf(const ColladaFile &file, const ColladaGeometry &geometry,
                              const ColladaPrimitive &primitive)
{
    const auto find = [](const auto &inputs, std::string_view semantic) {
        return std::find_if(inputs.begin(), inputs.end(),
                            [&](const auto &input) { return input.semantic == semantic; });
    };
    std::vector<ColladaInput> ofVertices;
    if (!readInputs(*geometry.vertices, ofVertices))
        return {};
    const auto vertex = find(primitive.inputs, "VERTEX");
    const auto position = find(ofVertices, "POSITION");
    if (vertex == primitive.inputs.end() || position == ofVertices.end())
        return {};
    const auto numbers = file.sources.find(position->source);
    if (numbers == file.sources.end() || numbers->second.stride < 3)
        return {};
    std::vector<Vec3> positions;
    const auto stride = static_cast<std::size_t>(numbers->second.stride);
    for (int c = 0; c < primitive.cornerCount(); ++c) {
        const int row = primitive.indices[static_cast<std::size_t>(c) * primitive.stride + vertex->offset];
        if (row >= numbers->second.rows())
            return {};
        const double *p = numbers->second.values.data() + stride * static_cast<std::size_t>(row);
        positions.emplace_back(p[0], p[1], p[2]);
    }
    return positions;
}

} // namespace autocuts
