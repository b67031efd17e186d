#include "model/io/gltf/gltfrewriter.h"

#include "model/io/formats/materiallooks.h"
#include "model/io/gltf/gltfappender.h"
#include "model/io/gltf/gltflooks.h"
#include "model/io/gltf/gltfprimitive.h"
#include "model/io/gltf/gltftextures.h"
#include "model/io/gltf/gltfuvnames.h"
#include "model/io/gltf/gltfvertices.h"

#include <algorithm>
#include <set>

namespace autocuts {

namespace {

constexpr int maxTexcoords = 8;

//! A primitive in the scene.
struct Member
{
    const GltfPiece *piece;
    std::size_t firstCorner, cornerCount; //!< in Group::corners
};

//! Primitives with the same attributes. They share their new ones, too.
struct Group
{
    GltfPrimitive data; //!< of the first member, with the corners of all
    std::vector<Member> members;
    std::vector<std::size_t> sceneCorner; //!< of each corner
    std::map<int, FileUvs> changed;       //!< UVs of the sets that change
    std::vector<int> zeroSets;            //!< sets that are missing below a changed one
    bool dropsTangents = false;
    GltfVertexMap map;
};

//! The texture coordinate set of the normal map; 0 without one.
int normalMapSet(const Json &root, const Json &primitive)
{
    const std::optional<std::size_t> material = wholeNumber(primitive, "material");
    if (!material)
        return 0;
    const Json &texture = member(element(root, "materials", *material), "normalTexture");
    const Json &transform = member(member(texture, "extensions"), "KHR_texture_transform");
    const std::size_t set =
        wholeNumber(transform, "texCoord").value_or(wholeNumber(texture, "texCoord").value_or(0));
    return static_cast<int>(std::min<std::size_t>(set, maxTexcoords));
}

void mergeAttributes(const GltfAttributes &attributes, const std::set<std::string> &without,
                     std::vector<const GltfElements *> &kept)
{
    for (const auto &[name, elements] : attributes) {
        if (!without.contains(name))
            kept.push_back(&elements);
    }
}

class GltfRewriter
{
public:
    GltfRewriter(const GltfSource &source, const Scene &scene, const QString &path)
        : mScene(scene), mPath(path), mFile(source.file), mOld(openGltf(mFile)), mData(mOld), mSource(source),
          mSets(texcoordsToWrite(source, scene))
    {}

    std::optional<GltfDocument> run();

private:
    const Json &oldPrimitive(const GltfPiece &piece) const
    {
        return element(mOld.json, "meshes", piece.mesh).at("primitives").at(piece.primitive);
    }
    Json &newPrimitive(const GltfPiece &piece)
    {
        return mNew.json["meshes"][piece.mesh]["primitives"][piece.primitive];
    }
    std::vector<std::vector<const GltfPiece *>> groupedPieces() const;
    Group read(const std::vector<const GltfPiece *> &pieces);
    std::vector<GltfAttributes> targetsOf(const GltfPiece &piece);
    void findChanges(Group &group) const;
    bool fileUvs(const Group &group, int set, const UvMatrix &uv, FileUvs &result) const;
    void mapCorners(Group &group);
    std::set<std::string> replacedNames(const Group &group) const;
    void forget(const Group &group);
    void write(const Group &group);
    QByteArray newUvs(const Group &group, int set, const FileUvs &uvs) const;
    GltfElements gathered(const GltfElements &old, const Group &group) const;
    void writeVertices(const Group &group, Json &attributes, Json &targets);
    void writeIndices(const Group &group);
    Json oldAccessor(const Json &attributes, const std::string &name) const
    {
        const auto number = wholeNumber(attributes, name.c_str());
        return number ? element(mOld.json, "accessors", *number) : Json::object();
    }
    void forgetUnusedExtension(const char *name);
    std::map<int, QString> setNames() const;
    std::map<std::size_t, TextureSet> newTextures();
    void writeUvs(const std::vector<Group> &changed);
    void writeTextures(const std::map<std::size_t, TextureSet> &textures);

    const Scene &mScene;
    QString mPath;
    GltfFile mFile;
    GltfDocument mOld, mNew;
    GltfData mData;
    const GltfSource &mSource;
    std::map<int, const UvSet *> mSets;
    std::optional<GltfAppender> mAppender;
};

std::vector<std::vector<const GltfPiece *>> GltfRewriter::groupedPieces() const
{
    std::vector<std::vector<const GltfPiece *>> groups;
    std::map<std::string, std::size_t> known;
    std::set<std::pair<std::size_t, std::size_t>> seen;
    for (const GltfPiece &piece : mSource.pieces) {
        // Of several nodes with one mesh, the first says the UVs.
        if (!seen.insert({piece.mesh, piece.primitive}).second)
            continue;
        const Json &primitive = oldPrimitive(piece);
        const Json &extensions = member(primitive, "extensions");
        std::string key = member(primitive, "attributes").dump() + member(primitive, "targets").dump() +
                          member(extensions, "KHR_draco_mesh_compression").dump() +
                          member(extensions, "EXT_mesh_features").dump();
        if (piece.mesh >= mSource.firstCopy) // or each copy would have the vertices of all
            key += std::to_string(piece.mesh);
        const auto [place, isNew] = known.try_emplace(key, groups.size());
        if (isNew)
            groups.emplace_back();
        groups[place->second].push_back(&piece);
    }
    return groups;
}

Group GltfRewriter::read(const std::vector<const GltfPiece *> &pieces)
{
    Group group;
    std::vector<std::uint32_t> corners;
    for (const GltfPiece *piece : pieces) {
        GltfPrimitive primitive = readPrimitive(mData, oldPrimitive(*piece));
        if (primitive.corners.size() != 3 * static_cast<std::size_t>(piece->faceCount))
            throw GltfError("its triangles have changed");
        group.members.push_back({piece, corners.size(), primitive.corners.size()});
        corners.insert(corners.end(), primitive.corners.begin(), primitive.corners.end());
        for (std::size_t c = 0; c < primitive.corners.size(); ++c) {
            const std::size_t inFace = piece->mirrored ? 2 - c % 3 : c % 3;
            const auto face = static_cast<std::size_t>(piece->firstFace) + c / 3;
            group.sceneCorner.push_back(static_cast<std::size_t>(mScene.mesh->faceStart[face]) + inFace);
        }
        if (piece == pieces.front())
            group.data = std::move(primitive);
    }
    group.data.corners = std::move(corners);
    return group;
}

//! The UVs of the corners as the file is to store them; false when they are the same as in the file.
bool GltfRewriter::fileUvs(const Group &group, int set, const UvMatrix &uv, FileUvs &result) const
{
    const auto found = group.data.attributes.find(texcoordName(set));
    const GltfElements *old =
        found != group.data.attributes.end() && found->second.components == 2 ? &found->second : nullptr;
    bool isChanged = false;
    result.reserve(group.sceneCorner.size());
    for (std::size_t c = 0; c < group.sceneCorner.size(); ++c) {
        const std::uint32_t vertex = group.data.corners[c];
        const auto row = uv.row(static_cast<Eigen::Index>(group.sceneCorner[c]));
        std::array<double, 2> value{0, 1};
        if (old)
            value = {old->value(vertex, 0), old->value(vertex, 1)};
        if (row.allFinite() && !(old && row.x() == value[0] && row.y() == 1 - value[1])) {
            value = {row.x(), 1 - row.y()};
            isChanged = true;
        }
        result.push_back({static_cast<float>(value[0]), static_cast<float>(value[1])});
    }
    return isChanged;
}

void GltfRewriter::findChanges(Group &group) const
{
    for (const auto &[set, uv] : mSets) {
        FileUvs uvs;
        if (fileUvs(group, set, uv->uv, uvs))
            group.changed[set] = std::move(uvs);
    }
    if (group.changed.empty())
        return;
    // The numbers of the sets must have no gaps.
    for (int set = 0; set < group.changed.rbegin()->first; ++set) {
        if (!group.changed.contains(set) && !group.data.attributes.contains(texcoordName(set)))
            group.zeroSets.push_back(set);
    }
    for (const Member &m : group.members)
        group.dropsTangents |= group.changed.contains(normalMapSet(mOld.json, oldPrimitive(*m.piece)));
}

std::set<std::string> GltfRewriter::replacedNames(const Group &group) const
{
    std::set<std::string> names;
    for (const auto &[set, uvs] : group.changed)
        names.insert(texcoordName(set));
    if (group.dropsTangents)
        names.insert("TANGENT");
    return names;
}

std::vector<GltfAttributes> GltfRewriter::targetsOf(const GltfPiece &piece)
{
    std::vector<GltfAttributes> result;
    for (const Json &target : member(oldPrimitive(piece), "targets")) {
        result.emplace_back();
        for (const auto &[name, accessor] : target.items())
            result.back()[name] = mData.elements(requiredNumber(target, name.c_str()));
    }
    return result;
}

void GltfRewriter::mapCorners(Group &group)
{
    const std::set<std::string> replaced = replacedNames(group);
    const std::vector<GltfAttributes> targets = targetsOf(*group.members.front().piece);
    std::vector<const GltfElements *> kept;
    mergeAttributes(group.data.attributes, replaced, kept);
    for (const GltfAttributes &target : targets) {
        mergeAttributes(target, replaced, kept);
        for (const auto &[name, elements] : target) {
            if (elements.count != group.data.vertexCount)
                throw GltfError("a morph target has another number of vertices than its mesh");
        }
    }
    std::vector<FileUvs> uvs;
    for (const auto &[set, values] : group.changed)
        uvs.push_back(values);
    group.map = mapVertices(group.data.corners, kept, uvs);
    const Json &extensions = member(oldPrimitive(*group.members.front().piece), "extensions");
    group.map.same &= member(extensions, "KHR_draco_mesh_compression").is_null();
}

//! Takes out of the new file what write() will replace.
void GltfRewriter::forget(const Group &group)
{
    const std::set<std::string> replaced = replacedNames(group);
    const auto clear = [&](Json &attributes) {
        for (auto &[name, accessor] : attributes.items()) {
            if (!group.map.same || replaced.contains(name))
                accessor = nullptr;
        }
        if (group.dropsTangents)
            attributes.erase("TANGENT");
    };
    for (const Member &m : group.members) {
        Json &primitive = newPrimitive(*m.piece);
        clear(primitive["attributes"]);
        if (primitive.contains("targets")) {
            for (Json &target : primitive["targets"])
                clear(target);
        }
        if (group.map.same)
            continue;
        if (primitive.contains("mode"))
            primitive["mode"] = 4; // a list of triangles
        primitive["indices"] = nullptr;
        if (primitive.contains("extensions")) {
            primitive["extensions"].erase("KHR_draco_mesh_compression");
            if (primitive["extensions"].empty())
                primitive.erase("extensions");
        }
    }
}

GltfElements GltfRewriter::gathered(const GltfElements &old, const Group &group) const
{
    GltfElements result = old;
    result.count = group.map.oldVertex.size();
    result.bytes.clear();
    result.bytes.reserve(static_cast<qsizetype>(result.count) * static_cast<qsizetype>(result.size));
    for (const std::uint32_t vertex : group.map.oldVertex)
        result.bytes.append(old.at(vertex), static_cast<qsizetype>(old.size));
    return result;
}

//! UVs of all vertices of the file.
QByteArray GltfRewriter::newUvs(const Group &group, int set, const FileUvs &uvs) const
{
    std::vector<std::array<float, 2>> rows;
    if (group.map.same) {
        rows.resize(group.data.vertexCount, {0, 1});
        const auto old = group.data.attributes.find(texcoordName(set));
        for (std::size_t v = 0; v < rows.size() && old != group.data.attributes.end(); ++v) {
            for (int k = 0; k < std::min(2, old->second.components); ++k)
                rows[v][static_cast<std::size_t>(k)] = static_cast<float>(old->second.value(v, k));
        }
        for (std::size_t c = 0; c < uvs.size(); ++c)
            rows[group.data.corners[c]] = uvs[c];
    } else {
        for (const std::uint32_t corner : group.map.corner)
            rows.push_back(uvs[corner]);
    }
    return {reinterpret_cast<const char *>(rows.data()),
            static_cast<qsizetype>(rows.size() * sizeof(std::array<float, 2>))};
}

//! Writes what is null, and the sets that are new.
void GltfRewriter::writeVertices(const Group &group, Json &attributes, Json &targets)
{
    const Json &old = member(oldPrimitive(*group.members.front().piece), "attributes");
    std::map<std::size_t, std::size_t> written; // new accessors by old ones
    const auto write = [&](Json &to, const Json &from, const GltfAttributes &values) {
        for (auto &[name, accessor] : to.items()) {
            if (!accessor.is_null() || !values.contains(name))
                continue;
            const std::size_t number = requiredNumber(from, name.c_str());
            if (!written.contains(number))
                written[number] = mAppender->addVertices(element(mOld.json, "accessors", number),
                                                         gathered(values.at(name), group));
            accessor = written[number];
        }
    };
    for (const auto &[set, uvs] : group.changed)
        attributes[texcoordName(set)] =
            mAppender->addUvs(oldAccessor(old, texcoordName(set)), newUvs(group, set, uvs));
    for (const int set : group.zeroSets)
        attributes[texcoordName(set)] =
            mAppender->addUvs(Json::object(), newUvs(group, set, FileUvs(group.data.corners.size(), {0, 1})));
    write(attributes, old, group.data.attributes);
    const std::vector<GltfAttributes> values = targetsOf(*group.members.front().piece);
    const Json &oldTargets = member(oldPrimitive(*group.members.front().piece), "targets");
    for (std::size_t t = 0; t < values.size(); ++t)
        write(targets[t], oldTargets[t], values[t]);
}

void GltfRewriter::writeIndices(const Group &group)
{
    std::map<std::pair<std::size_t, std::vector<std::uint32_t>>, std::size_t> written;
    for (const Member &m : group.members) {
        const auto begin = group.map.cornerVertex.begin() + static_cast<std::ptrdiff_t>(m.firstCorner);
        const std::vector<std::uint32_t> indices(begin, begin + static_cast<std::ptrdiff_t>(m.cornerCount));
        const std::optional<std::size_t> old = wholeNumber(oldPrimitive(*m.piece), "indices");
        const Json like = old ? element(mOld.json, "accessors", *old) : Json();
        const auto [place, isNew] = written.try_emplace({old.value_or(SIZE_MAX), indices});
        if (isNew)
            place->second = mAppender->addIndices(like, indices);
        newPrimitive(*m.piece)["indices"] = place->second;
    }
}

void GltfRewriter::write(const Group &group)
{
    Json &first = newPrimitive(*group.members.front().piece);
    Json attributes = first["attributes"];
    Json targets = member(first, "targets");
    writeVertices(group, attributes, targets);
    for (const Member &m : group.members) {
        Json &primitive = newPrimitive(*m.piece);
        primitive["attributes"] = attributes;
        if (!targets.is_null())
            primitive["targets"] = targets;
    }
    if (!group.map.same)
        writeIndices(group);
}

//! Takes an extension of primitives off the lists when no primitive has it.
void GltfRewriter::forgetUnusedExtension(const char *name)
{
    for (const Json &mesh : member(mNew.json, "meshes")) {
        for (const Json &primitive : member(mesh, "primitives")) {
            if (member(primitive, "extensions").contains(name))
                return;
        }
    }
    for (const char *list : {"extensionsUsed", "extensionsRequired"}) {
        if (!mNew.json.contains(list))
            continue;
        Json &names = mNew.json[list];
        for (std::size_t i = names.size(); i-- > 0;) {
            if (names[i] == name)
                names.erase(i);
        }
        if (names.empty())
            mNew.json.erase(list);
    }
}

std::optional<GltfDocument> GltfRewriter::run()
{
    std::vector<Group> changed;
    for (const std::vector<const GltfPiece *> &pieces : groupedPieces()) {
        Group group = read(pieces);
        findChanges(group);
        if (group.changed.empty())
            continue;
        mapCorners(group);
        changed.push_back(std::move(group));
    }
    const std::map<int, QString> names = setNames();
    const std::map<std::size_t, TextureSet> textures = newTextures();
    if (changed.empty() && names == mSource.setNames && textures.empty())
        return {};
    mNew = mOld;
    if (names != mSource.setNames)
        setGltfUvNames(mNew.json, names);
    writeUvs(changed);
    writeTextures(textures);
    return std::move(mNew);
}

//! The names of all sets that the new file has.
std::map<int, QString> GltfRewriter::setNames() const
{
    std::map<int, QString> names = mSource.setNames;
    for (const auto &[number, set] : mSets)
        names[number] = set->name;
    return names;
}

//! The pictures of the scene that are not those of the file, by material.
std::map<std::size_t, TextureSet> GltfRewriter::newTextures()
{
    std::map<std::size_t, TextureSet> result;
    const Json &materials = member(mOld.json, "materials");
    GltfTextures textures(mData);
    for (std::size_t m = 0; m < std::min(materials.size(), mScene.materialNames.size()); ++m) {
        TextureSet before = textures.setOfMaterial(materials[m]);
        before[TextureChannel::BaseColor].picture = textures.ofMaterial(materials[m]);
        for (const auto &[channel, entry] : mScene.fileSet(static_cast<int>(m))) {
            if (!entry.picture.isEmpty() && entry.picture != before[channel].picture)
                result[m][channel] = entry;
        }
    }
    return result;
}

void GltfRewriter::writeTextures(const std::map<std::size_t, TextureSet> &textures)
{
    if (textures.empty())
        return;
    int texcoord = 0;
    for (const auto &[number, set] : mSets) {
        if (!mScene.uvSets.empty() && set == &mScene.uvSets.front())
            texcoord = number;
    }
    MaterialLooks looks(mScene, mPath);
    GltfPictures pictures(mNew, looks, mPath.endsWith(QLatin1String(".glb"), Qt::CaseInsensitive));
    for (const auto &[material, set] : textures)
        setGltfTextures(mNew.json["materials"][material], set, texcoord, pictures);
}

void GltfRewriter::writeUvs(const std::vector<Group> &changed)
{
    if (changed.empty())
        return;
    for (const Group &group : changed)
        forget(group);
    mAppender.emplace(mNew);
    mAppender->dropUnused(usesIn(mOld.json));
    for (const Group &group : changed)
        write(group);
    forgetUnusedExtension("KHR_draco_mesh_compression");
}

} // namespace

std::map<int, const UvSet *> texcoordsToWrite(const GltfSource &source, const Scene &scene)
{
    std::map<int, const UvSet *> result;
    std::vector<const UvSet *> others;
    for (const UvSet &set : scene.uvSets) {
        const auto number = std::find_if(source.texcoords.begin(), source.texcoords.end(), [&](int n) {
            return source.setNames.at(n) == set.name && !result.contains(n);
        });
        if (number == source.texcoords.end())
            others.push_back(&set);
        else
            result[*number] = &set;
    }
    std::vector<int> free;
    for (const bool inFile : {true, false}) {
        for (int n = 0; n < maxTexcoords; ++n) {
            const bool isThere =
                std::find(source.texcoords.begin(), source.texcoords.end(), n) != source.texcoords.end();
            if (isThere == inFile && !result.contains(n))
                free.push_back(n);
        }
    }
    for (std::size_t i = 0; i < std::min(free.size(), others.size()); ++i)
        result[free[i]] = others[i];
    return result;
}

std::optional<GltfDocument> rewriteGltf(const GltfSource &source, const Scene &scene, const QString &path)
{
    return GltfRewriter(source, scene, path).run();
}

} // namespace autocuts
