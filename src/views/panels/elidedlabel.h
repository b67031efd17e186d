// A line of text that gives way.
#pragma once

#include <QWidget>

namespace autocuts {

//! Shows one line, shortened by an ellipsis when there is no room; the whole text is then in the tooltip.
class ElidedLabel final : public QWidget
{
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget *parent = nullptr);

    const QString &text() const { return mText; }
    void setText(const QString &text);

    //! Takes the width of its text up to this, instead of whatever is left over.
    void setWidest(int width);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void updateToolTip();

    QString mText;
    int mWidest = 0; //!< 0: no limit
};

} // namespace autocuts
