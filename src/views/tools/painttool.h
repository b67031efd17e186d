// The tool for painting seam weights.
#pragma once

#include "views/tools/weighttool.h"

namespace autocuts {

//! The effect of the brush.
enum class Paint { KeepTogether, AttractCuts, Erase };

//! Paints weights of seams (paper, section 4, "Assisted cutting").
class PaintTool final : public WeightTool
{
    Q_OBJECT

public:
    explicit PaintTool(const StudioContext &context, QObject *parent = nullptr);

    Paint paint() const { return mPaint; }

    QString hint() const override;
    bool wantsKey(const QKeyEvent &event) const override;
    bool keyPress(const QKeyEvent &event, ToolCanvas &canvas) override;

protected:
    //! Shift erases, Ctrl reverses the effect.
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
    void setPaint(Paint paint);

    //! The chosen effect, and that with the modifiers.
    Paint mPaint = Paint::KeepTogether, mCurrent = Paint::KeepTogether;
    std::vector<double> mBase; //!< weights of all corner pairs before the stroke
};

} // namespace autocuts
