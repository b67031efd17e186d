#include "model/io/assimp/assimpimport.h"

#include "model/io/assimp/assimpcollada.h"
#include "model/io/assimp/assimpstream.h"
#include "model/io/assimp/assimpunits.h"
#include "model/io/assimp/blendnames.h"
#include "model/io/files/unzipping.h"
#include "model/io/files/xmlspans.h"

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <string_view>

namespace autocuts {

namespace {

//! In lower case.
std::string suffixOf(const std::string &path)
{
    const std::size_t dot = path.rfind('.');
    std::string suffix = dot == std::string::npos ? std::string() : path.substr(dot + 1);
    for (char &c : suffix)
        c = static_cast<char>(c | 0x20);
    return suffix;
}

//! \param high place of the high byte in each pair: 0 or 1
std::string fromUtf16(std::string_view bytes, std::size_t high)
{
    std::string text;
    text.reserve(bytes.size() / 2);
    char32_t first = 0; // of a surrogate pair
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        const char32_t unit = static_cast<unsigned char>(bytes[i + high]) << 8 |
                              static_cast<unsigned char>(bytes[i + 1 - high]);
        const bool isFirst = unit >= 0xD800 && unit < 0xDC00;
        const bool isSecond = unit >= 0xDC00 && unit < 0xE000;
        if (isSecond && first != 0)
            appendUtf8(text, 0x10000 + ((first - 0xD800) << 10) + (unit - 0xDC00));
        else if (!isFirst && !isSecond)
            appendUtf8(text, unit);
        first = isFirst ? unit : 0;
    }
    return text;
}

//! XML in UTF-8 without a byte order mark.
std::string asUtf8(std::string bytes)
{
    const std::string_view start = std::string_view(bytes).substr(0, 2);
    if (start == "\xFF\xFE" || start == std::string_view("<\0", 2))
        return fromUtf16(std::string_view(bytes).substr(start == "\xFF\xFE" ? 2 : 0), 1);
    if (start == "\xFE\xFF" || start == std::string_view("\0<", 2))
        return fromUtf16(std::string_view(bytes).substr(start == "\xFE\xFF" ? 2 : 0), 0);
    return bytes;
}

//! Takes out white space before the first tag and between a tag and the text behind it. Assimp expects
//! numbers at once.
std::string withoutLeadingSpace(const std::string &xml)
{
    constexpr const char *space = " \t\r\n";
    std::string result;
    result.reserve(xml.size());
    std::size_t at = 0;
    while (true) {
        at = xml.find_first_not_of(space, at);
        if (at == std::string::npos)
            return result;
        const std::size_t end = xml.find('>', at);
        if (end == std::string::npos)
            return result.append(xml, at);
        result.append(xml, at, end + 1 - at);
        at = end + 1;
    }
}

//! Assimp takes a comma between digits for a decimal point.
std::string withSpaceBehindCommas(const std::string &text)
{
    std::string result;
    result.reserve(text.size() + text.size() / 8);
    const auto isDigit = [&text](std::size_t i) {
        return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        result += text[i];
        if (text[i] == ',' && isDigit(i - 1) && isDigit(i + 1))
            result += ' ';
    }
    return result;
}

std::string contentOf(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

//! The text of a Collada file, or of the one in an archive; empty for other files.
std::string colladaTextOf(const std::string &path)
{
    if (suffixOf(path) == "dae")
        return asUtf8(contentOf(path));
    if (suffixOf(path) == "zae")
        return asUtf8(beginInArchive(contentOf(path), ".dae", std::numeric_limits<std::size_t>::max()));
    return {};
}

//! The objects of a .blend file get their names back.
void nameBack(aiNode &node, const std::map<std::string, std::string> &names)
{
    if (const auto name = names.find(node.mName.C_Str()); name != names.end())
        node.mName = name->second;
    for (unsigned c = 0; c < node.mNumChildren; ++c)
        nameBack(*node.mChildren[c], names);
}

//! The scene of a .blend file, or null. It belongs to the importer.
const aiScene *importedBlend(Assimp::Importer &importer, const std::string &path)
{
    const BlendObjects objects = withDistinctNames(contentOf(path));
    importer.ReadFileFromMemory(objects.bytes.data(), objects.bytes.size(), 0, "blend");
    std::map<std::string, std::string> names;
    for (std::size_t n = 0; n < objects.names.size(); ++n)
        names[blendName(n)] = objects.names[n];
    aiScene *scene = const_cast<aiScene *>(importer.GetScene());
    if (!scene || !scene->mRootNode)
        return nullptr;
    const auto nameBackAll = [&names](auto *const *list, unsigned count) {
        for (unsigned n = 0; n < count; ++n) {
            if (const auto name = names.find(list[n]->mName.C_Str()); name != names.end())
                list[n]->mName = name->second;
        }
    };
    nameBack(*scene->mRootNode, names);
    nameBackAll(scene->mCameras, scene->mNumCameras);
    nameBackAll(scene->mLights, scene->mNumLights);
    return scene;
}

//! The scene with its root, or null. It belongs to the importer.
const aiScene *imported(Assimp::Importer &importer, const std::string &path, std::string &error)
{
    // Without this, Assimp reads an FBX node as a chain of helper nodes, one for each part of its transform.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    // Without this, Assimp makes up a mesh for files that have none.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    const std::string suffix = suffixOf(path);
    const auto readText = [&importer](const std::string &xml, const char *format) {
        return importer.ReadFileFromMemory(xml.data(), xml.size(), 0, format);
    };
    const aiScene *scene = nullptr;
    if (suffix == "blend")
        scene = importedBlend(importer, path);
    else if (suffix == "x3d" || suffix == "xgl")
        scene = readText(withSpaceBehindCommas(asUtf8(contentOf(path))), suffix.c_str());
    else if (const std::string xgl = suffix == "zgl" ? unzipped(contentOf(path)) : std::string();
             !xgl.empty())
        scene = readText(withSpaceBehindCommas(xgl), "xgl");
    else if (suffix == "zgl")
        return nullptr; // its contents are damaged
    else
        scene = importer.ReadFile(path, 0);
    if (!scene)
        error = importer.GetErrorString();
    // What Assimp cannot read by itself: UTF-16, and white space before numbers.
    if (!scene && suffix == "dae")
        scene = readText(withoutLeadingSpace(asUtf8(contentOf(path))), "dae");
    return scene && scene->mRootNode ? scene : nullptr;
}

//! Takes out what belongs to a node that is not in the scene.
template <typename T, typename Name>
void dropWithoutNode(const aiScene &scene, T **list, unsigned &count, const Name &nodeName)
{
    T **end = list + count;
    T **kept = std::stable_partition(
        list, end, [&](const T *entry) { return scene.mRootNode->FindNode(nodeName(*entry)) != nullptr; });
    std::for_each(kept, end, std::default_delete<T>());
    count = static_cast<unsigned>(kept - list);
}

//! Assimp's exporters crash on what belongs to no node: channels of an FBX with pivots that are animated,
//! bones of X files, cameras and lights of OpenGEX files.
void dropAllWithoutNode(aiScene &scene)
{
    const auto own = [](const auto &entry) { return entry.mName; };
    for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
        aiAnimation &animation = *scene.mAnimations[a];
        dropWithoutNode(scene, animation.mChannels, animation.mNumChannels,
                        [](const aiNodeAnim &channel) { return channel.mNodeName; });
    }
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        dropWithoutNode(scene, scene.mMeshes[m]->mBones, scene.mMeshes[m]->mNumBones, own);
    dropWithoutNode(scene, scene.mCameras, scene.mNumCameras, own);
    dropWithoutNode(scene, scene.mLights, scene.mNumLights, own);
}

//! Assimp gives the cameras of glTF files the place of their node once more, and a width that is not that of
//! their height: it multiplies angles.
void mendGltfCameras(aiScene &scene)
{
    for (unsigned c = 0; c < scene.mNumCameras; ++c) {
        aiCamera &camera = *scene.mCameras[c];
        camera.mPosition = {};
        if (!(camera.mAspect > 0))
            camera.mAspect = 1; // as Assimp takes it
        const float height = camera.mHorizontalFOV / camera.mAspect;
        camera.mHorizontalFOV = 2 * std::atan(std::tan(height / 2) * camera.mAspect);
    }
}

} // namespace

void importWithAssimp(const std::string &path, std::FILE *out, void (*finish)(int code))
{
    Assimp::Importer importer;
    std::string error;
    try {
        if (imported(importer, path, error)) {
            const std::unique_ptr<aiScene> scene(importer.GetOrphanedScene());
            dropAllWithoutNode(*scene);
            if (const std::string collada = colladaTextOf(path); !collada.empty())
                completeColladaNodes(*scene, collada);
            if (suffixOf(path) == "glb" || suffixOf(path) == "gltf")
                mendGltfCameras(*scene);
            completeUnits(*scene, suffixOf(path), path);
            writeAssimpScene(*scene, out);
            finish(readerexit::done);
        }
    } catch (const std::exception &e) {
        error = e.what();
    }
    std::fputc('\0', out);
    std::fwrite(error.data(), 1, error.size(), out);
    std::fflush(out);
    finish(readerexit::unreadable);
}

} // namespace autocuts
