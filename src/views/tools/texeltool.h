// The tool for painting texel weights.
#pragma once

#include "views/tools/weighttool.h"

namespace autocuts {

//! Paints how many times the texels per length faces are to have.
class TexelTool final : public WeightTool
{
    Q_OBJECT

public:
    explicit TexelTool(const StudioContext &context, QObject *parent = nullptr);

    double weight() const { return mWeight; }

    QString hint() const override;

protected:
    //! Shift goes back to 1, Ctrl is the inverse.
    void takeModifiers(Qt::KeyboardModifiers modifiers) override;
    std::size_t beginStroke(const Document &document) override;
    std::vector<BrushTouch> touched(const ToolCanvas &canvas, const QPointF &middle,
                                    const PickResult &pick) const override;
    std::vector<int> mirrorImages(const MeshData &mesh) const override;
    std::unique_ptr<DocumentCommand> commandFor(Document &document,
                                                const std::map<int, double> &shares) const override;
    ToolOption effectOption() override;
    QString effectText() const override;
    QColor effectColor(const ViewColors &colors) const override;

private:
    double mWeight = 2, mCurrent = 2; //!< the chosen weight, and that with the modifiers
    std::vector<double> mBase;        //!< weights of all faces before the stroke
};

} // namespace autocuts
