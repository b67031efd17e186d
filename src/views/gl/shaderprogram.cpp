#include "views/gl/shaderprogram.h"

#include <stdexcept>

//! Needed because the resources are in a static library, where the linker would drop them. Must be outside of
//! any namespace.
static void initResources()
{
    Q_INIT_RESOURCE(autocuts);
}

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

std::unique_ptr<QOpenGLShaderProgram> makeShaderProgram(const QString &vertexName,
                                                        const QString &fragmentName)
{
    [[maybe_unused]] static const bool initialized = (initResources(), true);
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const QString path = u":/shaders/%1"_s;
    if (!program->addShaderFromSourceFile(QOpenGLShader::Vertex, path.arg(vertexName + u".vert"_s)) ||
        !program->addShaderFromSourceFile(QOpenGLShader::Fragment, path.arg(fragmentName + u".frag"_s)) ||
        !program->link())
        throw std::runtime_error(
            (vertexName + u", "_s + fragmentName + u": "_s + program->log()).toStdString());
    return program;
}

} // namespace autocuts
