#include "views/gl/shaderprogram.h"

#include <QFile>

#include <stdexcept>

//! Needed because the resources are in a static library, where the linker would drop them. Must be outside of
//! any namespace.
static void initResources()
{
    Q_INIT_RESOURCE(autocuts);
}

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The text of a shader, with the files that lines #include "NAME" name in their places.
QByteArray shaderText(const QString &name)
{
    QFile file(u":/shaders/%1"_s.arg(name));
    if (!file.open(QIODevice::ReadOnly))
        throw std::runtime_error((name + u" is missing"_s).toStdString());
    QByteArray text = file.readAll();
    constexpr QByteArrayView include = "#include \"";
    for (qsizetype begin = text.indexOf(include); begin >= 0; begin = text.indexOf(include)) {
        const qsizetype nameBegin = begin + include.size(), end = text.indexOf('"', nameBegin);
        const QByteArray included = shaderText(QString::fromLatin1(text.mid(nameBegin, end - nameBegin)));
        text.replace(begin, end + 1 - begin, included);
    }
    return text;
}

} // namespace

std::unique_ptr<QOpenGLShaderProgram>
makeShaderProgram(const QString &vertexName, const QString &fragmentName, const QByteArrayList &defines)
{
    [[maybe_unused]] static const bool initialized = (initResources(), true);
    const auto text = [&defines](const QString &name) {
        QByteArray all = shaderText(name);
        for (const QByteArray &define : defines)
            all.insert(all.indexOf('\n') + 1, "#define " + define + '\n'); // after the version
        return all;
    };
    auto program = std::make_unique<QOpenGLShaderProgram>();
    if (!program->addShaderFromSourceCode(QOpenGLShader::Vertex, text(vertexName + u".vert"_s)) ||
        !program->addShaderFromSourceCode(QOpenGLShader::Fragment, text(fragmentName + u".frag"_s)) ||
        !program->link())
        throw std::runtime_error(
            (vertexName + u", "_s + fragmentName + u": "_s + program->log()).toStdString());
    return program;
}

} // namespace autocuts
