#include "model/io/formats/meshformats.h"

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

const std::vector<MeshFormat> &meshFormats()
{
    static const std::vector<MeshFormat> formats{
        {u"obj"_s, u"model/obj"_s},           {u"ply"_s, u"model/x-ply"_s},
        {u"stl"_s, u"model/stl"_s},           {u"off"_s, u"model/x-off"_s},
        {u"gltf"_s, u"model/gltf+json"_s},    {u"glb"_s, u"model/gltf-binary"_s},
        {u"fbx"_s, u"model/x-fbx"_s},         {u"dae"_s, u"model/vnd.collada+xml"_s, true},
        {u"3ds"_s, u"image/x-3ds"_s, true},   {u"blend"_s, u"application/x-blender"_s},
        {u"3mf"_s, u"model/3mf"_s, true},     {u"ac"_s, u"model/x-ac3d"_s},
        {u"ac3d"_s, u"model/x-ac3d"_s},       {u"acc"_s, u"model/x-ac3d"_s},
        {u"amf"_s, u"model/x-amf"_s, true},   {u"ase"_s, u"model/x-ase"_s, true},
        {u"b3d"_s, u"model/x-b3d"_s},         {u"cob"_s, u"model/x-cob"_s, true},
        {u"dxf"_s, u"image/vnd.dxf"_s, true}, {u"hmp"_s, u"model/x-hmp"_s, true},
        {u"ifc"_s, u"model/x-ifc"_s, true},   {u"iqm"_s, u"model/x-iqm"_s, true},
        {u"lwo"_s, u"image/x-lwo"_s},         {u"lws"_s, u"image/x-lws"_s},
        {u"lxo"_s, u"model/x-lxo"_s},         {u"md2"_s, u"model/x-md2"_s, true},
        {u"md3"_s, u"model/x-md3"_s, true},   {u"md5mesh"_s, u"model/x-md5mesh"_s, true},
        {u"mdc"_s, u"model/x-mdc"_s, true},   {u"mdl"_s, u"model/x-mdl"_s, true},
        {u"ms3d"_s, u"model/x-ms3d"_s},       {u"nff"_s, u"model/x-nff"_s},
        {u"ogex"_s, u"model/x-ogex"_s, true}, {u"pmx"_s, u"model/x-pmx"_s},
        {u"q3o"_s, u"model/x-q3o"_s},         {u"q3s"_s, u"model/x-q3s"_s},
        {u"sib"_s, u"model/x-sib"_s},         {u"smd"_s, u"model/x-smd"_s, true},
        {u"x"_s, u"model/x-directx"_s},       {u"x3d"_s, u"model/x3d+xml"_s},
        {u"xgl"_s, u"model/x-xgl"_s},         {u"zae"_s, u"model/x-zae"_s, true},
        {u"zgl"_s, u"model/x-zgl"_s},
    };
    return formats;
}

bool hasMadeUpRoot(const QString &suffix)
{
    return std::any_of(meshFormats().begin(), meshFormats().end(), [&suffix](const MeshFormat &format) {
        return format.suffix == suffix && format.hasMadeUpRoot;
    });
}

bool isGltfFormat(const QString &format)
{
    return format == u"gltf"_s || format == u"glb"_s;
}

QStringList readableFormats()
{
    QStringList suffixes;
    for (const MeshFormat &format : meshFormats())
        suffixes << format.suffix;
    return suffixes;
}

QStringList writableFormats()
{
    return {u"obj"_s, u"glb"_s, u"gltf"_s, u"dae"_s, u"fbx"_s, u"ply"_s};
}

QString formatToWrite(const QString &format)
{
    if (writableFormats().contains(format))
        return format;
    const bool isBare = format.isEmpty() || format == u"stl"_s || format == u"off"_s;
    return isBare ? u"obj"_s : u"fbx"_s;
}

} // namespace autocuts
