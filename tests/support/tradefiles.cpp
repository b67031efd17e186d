#include "support/tradefiles.h"

#include <QDataStream>
#include <QIODevice>

#include <array>
#include <functional>
#include <zlib.h>

namespace tradefiles {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Width, height of the corners; two triangles of them.
constexpr std::array<std::array<int, 2>, 4> corners{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}};
constexpr std::array<int, 6> triangles{0, 1, 2, 0, 2, 3};

using Write = std::function<void(QDataStream &)>;

QByteArray binary(QDataStream::ByteOrder order, const Write &write)
{
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out.setByteOrder(order);
    out.setFloatingPointPrecision(QDataStream::SinglePrecision);
    write(out);
    return bytes;
}

QByteArray little(const Write &write)
{
    return binary(QDataStream::LittleEndian, write);
}

QByteArray big(const Write &write)
{
    return binary(QDataStream::BigEndian, write);
}

void raw(QDataStream &out, const QByteArray &bytes)
{
    out.writeRawData(bytes.constData(), int(bytes.size()));
}

//! Filled up with zeros.
void text(QDataStream &out, const QByteArray &name, qsizetype size)
{
    raw(out, name.leftJustified(size, '\0', true));
}

void ints(QDataStream &out, std::initializer_list<int> values)
{
    for (int value : values)
        out << qint32(value);
}

void floats(QDataStream &out, std::initializer_list<double> values)
{
    for (double value : values)
        out << float(value);
}

QByteArray number(double value)
{
    return QByteArray::number(value, 'g', 12);
}

//! A line for each corner. \param line with %x, %h and, for UVs, %u, %v and %d, a v that points down
QByteArray perCorner(const QByteArray &line, double scale = 1)
{
    QByteArray lines;
    for (const auto &[x, h] : corners) {
        QByteArray one = line;
        one.replace("%x", number(x * scale)).replace("%h", number(h * scale)).replace("%u", number(x / 2));
        lines += one.replace("%v", number(h)).replace("%d", number(1 - h));
    }
    return lines;
}

QByteArray unitSaid(const QByteArray &unit)
{
    return unit.isEmpty() ? QByteArray() : " unit=\"" + unit + '"';
}

//! \param more parts of the mesh
QByteArray x(const QByteArray &more = {})
{
    return "xof 0303txt 0032\nFrame Root {\n FrameTransformMatrix {\n  1.0,0.0,0.0,0.0, 0.0,1.0,0.0,0.0, "
           "0.0,0.0,1.0,0.0, 0.0,0.0,0.0,1.0;;\n }\n Mesh Sheet {\n  4;\n  0.0;0.0;0.0;,\n  2.0;0.0;0.0;,\n"
           "  2.0;1.0;0.0;,\n  0.0;1.0;0.0;;\n  1;\n  4;0,1,2,3;;\n  MeshTextureCoords {\n   4;\n"
           "   0.0;1.0;,\n   1.0;1.0;,\n   1.0;0.0;,\n   0.0;0.0;;\n  }\n" +
           more + " }\n}\n";
}

QByteArray ac()
{
    return "AC3Db\nMATERIAL \"white\" rgb 1 1 1  amb 1 1 1  emis 0 0 0  spec 0 0 0  shi 0  trans 0\n"
           "OBJECT world\nkids 1\nOBJECT poly\nname \"Sheet\"\ntexture \"sheet.png\"\nnumvert 4\n" +
           perCorner("%x %h 0\n") +
           "numsurf 1\nSURF 0x0\nmat 0\nrefs 4\n0 0 0\n1 1 0\n2 1 1\n3 0 1\nkids 0\n";
}

QByteArray ase()
{
    return "*3DSMAX_ASCIIEXPORT 200\n*GEOMOBJECT {\n *NODE_NAME \"Sheet\"\n *MESH {\n  *TIMEVALUE 0\n"
           "  *MESH_NUMVERTEX 4\n  *MESH_NUMFACES 2\n  *MESH_VERTEX_LIST {\n"
           "   *MESH_VERTEX 0 0 0 0\n   *MESH_VERTEX 1 2 0 0\n   *MESH_VERTEX 2 2 0 1\n"
           "   *MESH_VERTEX 3 0 0 1\n  }\n  *MESH_FACE_LIST {\n"
           "   *MESH_FACE 0: A: 0 B: 1 C: 2 AB: 1 BC: 1 CA: 0 *MESH_SMOOTHING 1 *MESH_MTLID 0\n"
           "   *MESH_FACE 1: A: 0 B: 2 C: 3 AB: 0 BC: 1 CA: 1 *MESH_SMOOTHING 1 *MESH_MTLID 0\n  }\n"
           "  *MESH_NUMTVERTEX 4\n  *MESH_TVERTLIST {\n   *MESH_TVERT 0 0 0 0\n   *MESH_TVERT 1 1 0 0\n"
           "   *MESH_TVERT 2 1 1 0\n   *MESH_TVERT 3 0 1 0\n  }\n  *MESH_NUMTVFACES 2\n"
           "  *MESH_TFACELIST {\n   *MESH_TFACE 0 0 1 2\n   *MESH_TFACE 1 0 2 3\n  }\n }\n}\n";
}

QByteArray cob()
{
    const QByteArray body = "Name Sheet,1\ncenter 0 0 0\nx axis 1 0 0\ny axis 0 1 0\nz axis 0 0 1\n"
                            "Transform\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\nWorld Vertices 4\n" +
                            perCorner("%x 0 %h\n") + "Texture Vertices 4\n" + perCorner("%u %v\n") +
                            "Faces 2\nFace verts 3 flags 0 mat 1\n<0,0> <1,1> <2,2> \n"
                            "Face verts 3 flags 0 mat 1\n<0,0> <2,2> <3,3> \n";
    return "Caligari V00.01ALH             \nPolH V0.06 Id 1 Parent 0 Size " +
           QByteArray::number(body.size()).rightJustified(8, '0') + '\n' + body +
           "END  V1.00 Id 0 Parent 0 Size        0\n";
}

QByteArray dxf()
{
    QByteArray face = "0\n3DFACE\n8\nSheet\n";
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const QByteArray n = QByteArray::number(int(c));
        face += "1" + n + '\n' + number(corners[c][0]) + "\n2" + n + "\n0\n3" + n + '\n' +
                number(corners[c][1]) + '\n';
    }
    return "0\nSECTION\n2\nENTITIES\n" + face + "0\nENDSEC\n0\nEOF\n";
}

QByteArray lwo()
{
    const auto chunk = [](const char *name, const QByteArray &content) {
        const QByteArray even = content.size() % 2 == 0 ? content : content + '\0';
        return name + big([&](QDataStream &out) { out << quint32(even.size()); }) + even;
    };
    const QByteArray points = big([](QDataStream &out) {
        for (const auto &[x, h] : corners)
            floats(out, {double(x), double(h), 0});
    });
    const QByteArray map = big([](QDataStream &out) {
        raw(out, "TXUV");
        out << quint16(2);
        text(out, "UVMap", 6);
        for (std::size_t c = 0; c < corners.size(); ++c) {
            out << quint16(c);
            floats(out, {corners[c][0] / 2.0, double(corners[c][1])});
        }
    });
    const QByteArray faces = big([](QDataStream &out) {
        raw(out, "FACE");
        out << quint16(4) << quint16(0) << quint16(1) << quint16(2) << quint16(3);
    });
    const QByteArray tags = big([](QDataStream &out) {
        raw(out, "SURF");
        out << quint16(0) << quint16(0);
    });
    const QByteArray body = "LWO2" + chunk("TAGS", QByteArray("Sheet\0", 6)) +
                            chunk("LAYR", QByteArray(18, '\0')) + chunk("PNTS", points) + chunk("VMAP", map) +
                            chunk("POLS", faces) + chunk("PTAG", tags) +
                            chunk("SURF", QByteArray("Sheet\0\0\0", 8));
    return chunk("FORM", body);
}

QByteArray lws()
{
    return "LWSC\n5\n\nLoadObjectLayer 1 10000000 sheet.lwo\nShowObject 7 -1 0.4 0.9 0.9\n";
}

QByteArray b3d()
{
    const auto chunk = [](const char *name, const QByteArray &content) {
        return name + little([&](QDataStream &out) { ints(out, {int(content.size())}); }) + content;
    };
    const QByteArray vertices = little([](QDataStream &out) {
        ints(out, {0, 1, 2});
        for (const auto &[x, h] : corners)
            floats(out, {double(x), double(h), 0, x / 2.0, double(1 - h)});
    });
    const QByteArray faces = little([](QDataStream &out) {
        ints(out, {-1});
        for (int c : triangles)
            ints(out, {c});
    });
    const QByteArray mesh =
        little([](QDataStream &out) { ints(out, {-1}); }) + chunk("VRTS", vertices) + chunk("TRIS", faces);
    const QByteArray node = little([](QDataStream &out) {
        text(out, "Sheet", 6);
        floats(out, {0, 0, 0, 1, 1, 1, 1, 0, 0, 0});
    });
    return chunk("BB3D", little([](QDataStream &out) { ints(out, {1}); }) +
                             chunk("NODE", node + chunk("MESH", mesh)));
}

//! Quake's models: x to the front, y to the left, z up.
QByteArray md2()
{
    constexpr int head = 68, skins = 64, uvs = 16, faces = 24, frame = 40 + 16;
    return little([](QDataStream &out) {
        raw(out, "IDP2");
        ints(out, {8, 64, 64, frame, 1, 4, 4, 2, 1, 1, head, head + skins, head + skins + uvs,
                   head + skins + uvs + faces, head + skins + uvs + faces + frame,
                   head + skins + uvs + faces + frame + 4});
        text(out, "sheet.pcx", skins);
        for (const auto &[x, h] : corners)
            out << qint16(32 * x) << qint16(64 * (1 - h));
        for (std::size_t c = 0; c < 6; c += 3) {
            for (int twice = 0; twice < 2; ++twice)
                out << quint16(triangles[c]) << quint16(triangles[c + 1]) << quint16(triangles[c + 2]);
        }
        floats(out, {1, 1, 1, 0, 0, 0});
        text(out, "rest", 16);
        for (const auto &[x, h] : corners)
            out << quint8(x) << quint8(0) << quint8(h) << quint8(0);
        ints(out, {0}); // no commands for OpenGL
    });
}

QByteArray md3()
{
    constexpr int head = 108, frame = 56, surface = 108, faces = 24, shader = 68, uvs = 32, vertices = 32;
    constexpr int end = surface + faces + shader + uvs + vertices;
    return little([](QDataStream &out) {
        raw(out, "IDP3");
        ints(out, {15});
        text(out, "sheet", 64);
        ints(out, {0, 1, 0, 1, 0, head, head + frame, head + frame, head + frame + end});
        floats(out, {0, 0, 0, 2, 0, 1, 0, 0, 0, 2});
        text(out, "rest", 16);
        raw(out, "IDP3");
        text(out, "Sheet", 64);
        ints(out, {0, 1, 1, 4, 2, surface, surface + faces, surface + faces + shader,
                   surface + faces + shader + uvs, end});
        for (int c : triangles)
            ints(out, {c});
        text(out, "sheet", 64);
        ints(out, {0});
        for (const auto &[x, h] : corners)
            floats(out, {x / 2.0, double(1 - h)});
        for (const auto &[x, h] : corners)
            out << qint16(64 * x) << qint16(0) << qint16(64 * h) << quint8(0) << quint8(0);
    });
}

QByteArray md5mesh()
{
    return "MD5Version 10\ncommandline \"\"\n\nnumJoints 1\nnumMeshes 1\n\njoints {\n\t\"origin\"\t-1 ( 0 0 "
           "0 ) "
           "( 0 0 0 )\t\t// \n}\n\nmesh {\n\tshader \"sheet\"\n\n\tnumverts 4\n"
           "\tvert 0 ( 0 1 ) 0 1\n\tvert 1 ( 1 1 ) 1 1\n\tvert 2 ( 1 0 ) 2 1\n\tvert 3 ( 0 0 ) 3 1\n"
           "\n\tnumtris 2\n\ttri 0 0 1 2\n\ttri 1 0 2 3\n\n\tnumweights 4\n"
           "\tweight 0 0 1 ( 0 0 0 )\n\tweight 1 0 1 ( 2 0 0 )\n\tweight 2 0 1 ( 2 0 1 )\n"
           "\tweight 3 0 1 ( 0 0 1 )\n}\n";
}

QByteArray ms3d()
{
    return little([](QDataStream &out) {
        raw(out, "MS3D000000");
        out << qint32(4) << quint16(4);
        for (const auto &[x, h] : corners) {
            out << quint8(0);
            floats(out, {double(x), double(h), 0});
            out << qint8(-1) << quint8(0);
        }
        out << quint16(2);
        for (std::size_t t = 0; t < 6; t += 3) {
            out << quint16(0);
            for (std::size_t c = t; c < t + 3; ++c)
                out << quint16(triangles[c]);
            floats(out, {0, 0, 1, 0, 0, 1, 0, 0, 1});
            for (std::size_t c = t; c < t + 3; ++c)
                out << float(corners[std::size_t(triangles[c])][0]) / 2;
            for (std::size_t c = t; c < t + 3; ++c)
                out << float(1 - corners[std::size_t(triangles[c])][1]);
            out << quint8(1) << quint8(0);
        }
        out << quint16(1) << quint8(0);
        text(out, "Sheet", 32);
        out << quint16(2) << quint16(0) << quint16(1) << qint8(-1) << quint16(0);
        floats(out, {24, 0});
        out << qint32(0) << quint16(0);
    });
}

QByteArray nff()
{
    return "p 4\n" + perCorner("%x %h 0\n");
}

QByteArray smd()
{
    const auto corner = [](int c) {
        const auto &[x, h] = corners[std::size_t(c)];
        return "0 " + number(x) + " 0 " + number(h) + " 0 -1 0 " + number(x / 2) + ' ' + number(h) + '\n';
    };
    QByteArray faces;
    for (std::size_t t = 0; t < 6; t += 3)
        faces += "sheet\n" + corner(triangles[t]) + corner(triangles[t + 1]) + corner(triangles[t + 2]);
    return "version 1\nnodes\n0 \"Sheet\" -1\nend\nskeleton\ntime 0\n0 0 0 0 0 0 0\nend\ntriangles\n" +
           faces + "end\n";
}

QByteArray x3d()
{
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<X3D profile=\"Interchange\" version=\"3.0\">\n"
           "<Scene>\n<Shape>\n<IndexedFaceSet coordIndex=\"0 1 2 3 -1\" texCoordIndex=\"0 1 2 3 -1\">\n"
           "<Coordinate point=\"" +
           perCorner("%x %h 0,") + "\"/>\n<TextureCoordinate point=\"" + perCorner("%u %v ") +
           "\"/>\n</IndexedFaceSet>\n</Shape>\n</Scene>\n</X3D>\n";
}

QByteArray xgl()
{
    QByteArray points, faces;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const QByteArray id = " ID=\"" + QByteArray::number(int(c)) + "\">";
        points += "<P" + id + number(corners[c][0]) + ',' + number(corners[c][1]) + ",0</P>\n<TC" + id +
                  number(corners[c][0] / 2) + ',' + number(corners[c][1]) + "</TC>\n";
    }
    for (std::size_t t = 0; t < 6; t += 3) {
        faces += "<F>\n<MATREF>0</MATREF>\n";
        for (int k = 0; k < 3; ++k) {
            const QByteArray id = QByteArray::number(triangles[t + std::size_t(k)]);
            const QByteArray tag = "FV" + QByteArray::number(k + 1) + '>';
            faces += '<' + tag + "<PREF>" + id + "</PREF><TCREF>" + id + "</TCREF></" + tag + '\n';
        }
        faces += "</F>\n";
    }
    return "<WORLD>\n<MESH ID=\"0\">\n<MAT ID=\"0\">\n<DIFF>0,1,0</DIFF>\n</MAT>\n" + points + faces +
           "</MESH>\n<OBJECT>\n<MESHREF>0</MESHREF>\n</OBJECT>\n</WORLD>\n";
}

QByteArray zgl()
{
    return qCompress(xgl()).mid(4); // Qt writes the size before the stream
}

QByteArray iqm()
{
    const QByteArray names = QByteArray("\0Sheet\0sheet\0\0\0", 15) + '\0';
    constexpr int head = 124, mesh = 24, arrays = 2 * 20, faces = 24, positions = 48;
    const int text = head, meshes = text + int(names.size()), vertexArrays = meshes + mesh;
    const int triangleData = vertexArrays + arrays, positionData = triangleData + faces;
    const int uvData = positionData + positions, size = uvData + 32;
    return little([&](QDataStream &out) {
        raw(out, QByteArray("INTERQUAKEMODEL\0", 16));
        ints(out, {2,      size,
                   0,      int(names.size()),
                   text,   1,
                   meshes, 2,
                   4,      vertexArrays,
                   2,      triangleData,
                   0,      0,
                   0,      0,
                   0,      0,
                   0,      0,
                   0,      0,
                   0,      0,
                   0,      0,
                   0});
        raw(out, names);
        ints(out, {1, 7, 0, 4, 0, 2});
        ints(out, {0, 0, 7, 3, positionData, 1, 0, 7, 2, uvData});
        for (int c : triangles)
            ints(out, {c});
        for (const auto &[x, h] : corners)
            floats(out, {double(x), 0, double(h)});
        for (const auto &[x, h] : corners)
            floats(out, {x / 2.0, double(1 - h)});
    });
}

QByteArray pmx()
{
    return little([](QDataStream &out) {
        const auto say = [&out](const QByteArray &name) {
            ints(out, {int(name.size())});
            raw(out, name);
        };
        raw(out, "PMX ");
        out << 2.0F << quint8(8);
        for (int size : {1, 0, 1, 1, 1, 1, 1, 1}) // UTF-8, no more UVs, indices of a byte
            out << quint8(size);
        for (int n = 0; n < 4; ++n)
            say("Sheet");
        ints(out, {4});
        for (const auto &[x, h] : corners) {
            floats(out, {double(x), double(h), 0, 0, 0, -1, x / 2.0, double(1 - h)});
            out << quint8(0) << qint8(0) << 1.0F;
        }
        ints(out, {6});
        for (int c : triangles)
            out << quint8(c);
        ints(out, {0, 1}); // textures, materials
        say("Sheet");
        say("Sheet");
        floats(out, {1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0});
        out << quint8(0);
        floats(out, {0, 0, 0, 1, 1});
        out << qint8(-1) << qint8(-1) << quint8(0) << quint8(1) << quint8(0);
        say("");
        ints(out, {6, 1}); // corners, bones
        say("root");
        say("root");
        floats(out, {0, 0, 0});
        out << qint8(-1) << qint32(0) << quint16(0);
        floats(out, {0, 0, 0});
        ints(out, {0, 0, 0, 0}); // morphs, frames, rigid bodies, joints
    });
}

} // namespace

//! Compresses nothing.
QByteArray zip(const std::vector<std::pair<QByteArray, QByteArray>> &files)
{
    QByteArray archive, directory;
    for (const auto &[name, content] : files) {
        const auto about = [&](QDataStream &out) {
            out << quint16(20) << quint16(0) << quint16(0) << quint16(0) << quint16(0x21)
                << quint32(
                       crc32(0, reinterpret_cast<const Bytef *>(content.constData()), uInt(content.size())))
                << quint32(content.size()) << quint32(content.size()) << quint16(name.size()) << quint16(0);
        };
        directory += little([&](QDataStream &out) {
            out << quint32(0x02014b50) << quint16(20);
            about(out);
            out << quint16(0) << quint16(0) << quint16(0) << quint32(0) << quint32(archive.size());
            raw(out, name);
        });
        archive += little([&](QDataStream &out) {
            out << quint32(0x04034b50);
            about(out);
            raw(out, name + content);
        });
    }
    const auto count = quint16(files.size());
    const QByteArray end = little([&](QDataStream &out) {
        out << quint32(0x06054b50) << quint16(0) << quint16(0) << count << count << quint32(directory.size())
            << quint32(archive.size()) << quint16(0);
    });
    return archive + directory + end;
}

QByteArray skinnedX(const std::vector<QByteArray> &bones)
{
    QByteArray weights =
        "  XSkinMeshHeader {\n   1;\n   1;\n   " + QByteArray::number(int(bones.size())) + ";\n  }\n";
    for (const QByteArray &bone : bones)
        weights += "  SkinWeights {\n   \"" + bone +
                   "\";\n   4;\n   0,1,2,3;\n   0.5,0.5,0.5,0.5;\n   1.0,0.0,0.0,0.0, 0.0,1.0,0.0,0.0, "
                   "0.0,0.0,1.0,0.0, 0.0,0.0,0.0,1.0;;\n  }\n";
    return x(weights);
}

QByteArray sheetAs3mf(const QByteArray &unit, double perMetre)
{
    const QByteArray model =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model" + unitSaid(unit) +
        " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n<resources>\n"
        "<object id=\"1\" type=\"model\">\n<mesh>\n<vertices>\n" +
        perCorner("<vertex x=\"%x\" y=\"0\" z=\"%h\" />\n", perMetre) +
        "</vertices>\n<triangles>\n<triangle v1=\"0\" v2=\"1\" v3=\"2\" />\n"
        "<triangle v1=\"0\" v2=\"2\" v3=\"3\" />\n</triangles>\n</mesh>\n</object>\n</resources>\n"
        "<build>\n<item objectid=\"1\" />\n</build>\n</model>\n";
    const QByteArray package = "http://schemas.openxmlformats.org/package/2006/";
    const QByteArray model3d = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
    return zip({{"[Content_Types].xml",
                 "<?xml version=\"1.0\"?><Types xmlns=\"" + package +
                     "content-types\"><Default Extension=\"model\" "
                     "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\" /></Types>"},
                {"_rels/.rels", "<?xml version=\"1.0\"?><Relationships xmlns=\"" + package +
                                    "relationships\"><Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
                                    "Type=\"" +
                                    model3d + "\" /></Relationships>"},
                {"3D/3dmodel.model", model}});
}

QByteArray sheetAsAmf(const QByteArray &unit, double perMetre)
{
    return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<amf" + unitSaid(unit) +
           " version=\"1.1\">\n<object id=\"1\">\n<mesh>\n<vertices>\n" +
           perCorner("<vertex><coordinates><x>%x</x><y>0</y><z>%h</z></coordinates></vertex>\n", perMetre) +
           "</vertices>\n<volume>\n<triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle>\n"
           "<triangle><v1>0</v1><v2>2</v2><v3>3</v3></triangle>\n</volume>\n</mesh>\n</object>\n</amf>\n";
}

QByteArray sheetAsOgex(double metres, bool zUp)
{
    const QByteArray up = zUp ? "z" : "y", place = zUp ? "{%x, 0.0, %h}, " : "{%x, %h, 0.0}, ";
    return "Metric (key = \"distance\") {float {" + number(metres) + "}}\nMetric (key = \"up\") {string {\"" +
           up +
           "\"}}\nGeometryNode $node1\n{\n\tName {string {\"Sheet\"}}\n\tObjectRef {ref {$geometry1}}\n"
           "\tTransform\n\t{\n\t\tfloat[16]\n\t\t{\n\t\t\t{1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, "
           "1.0, 0.0, 0.0, 0.0, 0.0, 1.0}\n\t\t}\n\t}\n}\nGeometryObject $geometry1\n{\n"
           "\tMesh (primitive = \"triangles\")\n\t{\n\t\tVertexArray (attrib = \"position\")\n\t\t{\n"
           "\t\t\tfloat[3]\n\t\t\t{\n\t\t\t\t" +
           perCorner(place, 1 / metres).chopped(2) +
           "\n\t\t\t}\n\t\t}\n\t\tVertexArray (attrib = \"texcoord\")\n\t\t{\n\t\t\tfloat[2]\n\t\t\t{\n"
           "\t\t\t\t" +
           perCorner("{%u, %v}, ").chopped(2) +
           "\n\t\t\t}\n\t\t}\n\t\tIndexArray\n\t\t{\n\t\t\tunsigned_int32[3]\n\t\t\t{\n"
           "\t\t\t\t{0, 1, 2}, {0, 2, 3}\n\t\t\t}\n\t\t}\n\t}\n}\n";
}

std::vector<TradeFile> sheets()
{
    return {{u"3mf"_s, sheetAs3mf("millimeter", 1000), false},
            {u"ac"_s, ac()},
            {u"amf"_s, sheetAsAmf("millimeter", 1000), false},
            {u"ase"_s, ase()},
            {u"b3d"_s, b3d()},
            {u"cob"_s, cob()},
            {u"dxf"_s, dxf(), false},
            {u"iqm"_s, iqm()},
            {u"lwo"_s, lwo()},
            {u"lws"_s, lws(), true, {{u"sheet.lwo"_s, lwo()}}},
            {u"md2"_s, md2()},
            {u"md3"_s, md3()},
            {u"md5mesh"_s, md5mesh()},
            {u"ms3d"_s, ms3d()},
            {u"nff"_s, nff(), false},
            {u"ogex"_s, sheetAsOgex(0.5, true)},
            {u"pmx"_s, pmx()},
            {u"smd"_s, smd()},
            {u"x"_s, x()},
            {u"x3d"_s, x3d()},
            {u"xgl"_s, xgl()},
            {u"zgl"_s, zgl()}};
}

} // namespace tradefiles
