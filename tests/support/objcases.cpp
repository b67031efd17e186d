#include "support/objcases.h"

#include "model/io/obj/objreader.h"

#include <QFile>

#include <cmath>

namespace autocuts::test {

const QByteArray triangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const QByteArray nastyObj = "# comment, \xd0\xbf\xd1\x80\xd0\xb8\xd0\xb2\xd0\xb5\xd1\x82 C:\\path\\\n"
                            "mtllib my materials.mtl\n\n"
                            "o  First  thing \n"
                            "v  0.000 -0.0 +0\r\n"
                            "v 1.50 0 0 0.1 0.2 0.3\n"
                            "v 1e0 1 \\\n  0\n"
                            "\tv 0 1 0 1.0\n"
                            "vt 0.25 0.5\nvt .5\nvt 1 1 0.0\n# between\nvt 0 1 # last\n"
                            "vn 0 0 1\n"
                            "vp 0.3 0.4\n"
                            "g group one\ns 1\nusemtl red\n"
                            "f 1/1/1  2/2/1\t3/3/1 # tail\n"
                            "f -4/-4/-1 -2/-2/-1 -1/-1/-1\n"
                            "s off\nusemtl blue\n"
                            "f 1//1 \\\n   2//1 \\\n 3//1 4//1   \n"
                            "o second\nf 1 2 4\n"
                            "p 1 2\nunknown statement 1/2/3\nf 1/ 3/ 4/\n  # end";

Scene parsed(const QByteArray &bytes)
{
    Result<Scene> scene = parseObj(bytes, QStringLiteral("test.obj"));
    if (!scene)
        qFatal("%s", qPrintable(scene.error().toString()));
    return std::move(scene).value();
}

void setNewUvs(Scene &scene)
{
    UvMatrix uv(scene.mesh->cornerCount(), 2);
    for (int c = 0; c < scene.mesh->cornerCount(); ++c) {
        const int v = scene.mesh->vertexWeld[scene.mesh->cornerVertex[c]];
        uv.row(c) << 1.0 / (v + 3), std::sqrt(v + 0.1) * 1e-3;
    }
    scene.uvSets = {{QStringLiteral("UVMap"), uv}};
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be opened");
}

} // namespace autocuts::test
