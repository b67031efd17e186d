// Gives nodes of a Collada file that show one geometry a geometry each.
#include "model/io/collada/colladamesh.h"
#include "model/io/collada/colladasource.h"

#include <algorithm>
#include <set>

namespace autocuts {

namespace {

//! Calls take(url) for all geometries that the nodes show, a node before those in it.
template <typename Take>
void eachUrl(const XmlElement &node, const Take &take)
{
    for (const XmlElement &child : node.children) {
        if (child.name == "instance_geometry")
            take(child.attribute("url"));
    }
    for (const XmlElement &child : node.children) {
        if (child.name == "node")
            eachUrl(child, take);
    }
}

//! The elements of the geometries, in the order of ColladaFile::geometries.
std::vector<const XmlElement *> geometryElements(const XmlElement &root)
{
    std::vector<const XmlElement *> elements;
    for (const XmlElement &library : root.children) {
        for (const XmlElement &element : library.children) {
            if (library.name == "library_geometries" && element.name == "geometry")
                elements.push_back(&element);
        }
    }
    return elements;
}

void collectIds(const XmlElement &element, std::set<std::string_view> &ids)
{
    ids.insert(element.attribute("id"));
    for (const XmlElement &child : element.children)
        collectIds(child, ids);
}

//! Puts an ending behind all ids of an element, and behind what refers to them in it.
void renameIds(const XmlElement &element, const std::set<std::string_view> &ids, const std::string &ending,
               std::vector<TextEdit> &edits)
{
    for (const auto &[name, value] : element.attributes) {
        const bool refers = value.starts_with('#') && ids.contains(value.substr(1));
        const bool named = name == "id" || (name == "name" && element.name == "geometry");
        if (value.empty() || !(refers || named))
            continue;
        const char *end = value.data() + value.size();
        edits.push_back({end, end, ending});
    }
    for (const XmlElement &child : element.children)
        renameIds(child, ids, ending, edits);
}

std::string copyOf(const XmlElement &geometry, const std::string &ending)
{
    std::set<std::string_view> ids;
    collectIds(geometry, ids);
    ids.erase(std::string_view());
    std::vector<TextEdit> edits;
    renameIds(geometry, ids, ending, edits);
    return edited(geometry.whole, std::move(edits));
}

} // namespace

void findUrls(const ColladaFile &file, std::string_view text, const std::vector<AssimpPiece> &pieces,
              std::vector<ColladaPlace> &places)
{
    std::map<std::string, std::vector<std::size_t>> urls; // by the id of the geometry
    for (const XmlElement &library : file.root.children) {
        for (const XmlElement &scene : library.children) {
            if (library.name != "library_visual_scenes" || scene.name != "visual_scene")
                continue;
            eachUrl(scene, [&](std::string_view url) {
                if (url.starts_with('#'))
                    urls[resolved(url.substr(1))].push_back(
                        static_cast<std::size_t>(url.data() - text.data()));
            });
        }
    }
    std::map<std::size_t, std::vector<int>> nodes; // by geometry, in the order of the pieces
    for (std::size_t p = 0; p < places.size(); ++p) {
        std::vector<int> &those = nodes[places[p].geometry];
        if (those.empty() || those.back() != pieces[p].node)
            those.push_back(pieces[p].node);
    }
    for (std::size_t p = 0; p < places.size(); ++p) {
        const std::vector<int> &those = nodes[places[p].geometry];
        const auto found = urls.find(file.geometries[places[p].geometry].id);
        // Skins, and nodes that are shown several times themselves, have no text of their own.
        if (found == urls.end() || found->second.size() != those.size())
            continue;
        const auto place = std::find(those.begin(), those.end(), pieces[p].node) - those.begin();
        places[p].url = found->second[static_cast<std::size_t>(place)];
    }
}

std::shared_ptr<const ColladaSource> withUniqueGeometries(const ColladaSource &source)
{
    const std::string_view text(source.bytes.constData(), static_cast<std::size_t>(source.bytes.size()));
    const ColladaFile file = *readCollada(text);
    const std::vector<const XmlElement *> elements = geometryElements(file.root);
    std::vector<std::vector<std::size_t>> urls(elements.size()); // of each geometry
    for (const ColladaPlace &place : source.places) {
        std::vector<std::size_t> &those = urls[place.geometry];
        if (place.url > 0 && std::find(those.begin(), those.end(), place.url) == those.end())
            those.push_back(place.url);
    }
    auto result = std::make_shared<ColladaSource>(source);
    std::vector<TextEdit> edits;
    std::vector<std::size_t> first; // the new number of each geometry, before its copies
    std::size_t count = 0;
    for (std::size_t g = 0; g < elements.size(); ++g) {
        first.push_back(count++);
        for (std::size_t i = 1; i < urls[g].size(); ++i, ++count) {
            std::string ending(1, '-');
            ending += std::to_string(i + 1);
            while (text.find(ending) != std::string_view::npos)
                ending.push_back('-');
            const char *behind = elements[g]->whole.data() + elements[g]->whole.size();
            edits.push_back({behind, behind, '\n' + copyOf(*elements[g], ending)});
            const std::string_view from = text.substr(urls[g][i]);
            const char *end = from.data() + std::min(from.find('"'), from.find('\''));
            edits.push_back({end, end, ending});
        }
    }
    for (ColladaPlace &place : result->places) {
        const std::vector<std::size_t> &those = urls[place.geometry];
        const auto found = std::find(those.begin(), those.end(), place.url);
        const std::size_t copy = found == those.end() ? 0 : static_cast<std::size_t>(found - those.begin());
        place = {first[place.geometry] + copy, place.primitive, 0};
    }
    result->bytes = QByteArray::fromStdString(edited(text, std::move(edits)));
    return result;
}

} // namespace autocuts
