// Captions and figures in one line, each at a fixed place.
#pragma once

#include <QString>
#include <QWidget>

#include <vector>

namespace autocuts {

//! Every figure has room for its widest text, so that nothing moves while numbers run. When the strip is too
//! narrow, the figures added last are left out.
class FigureStrip final : public QWidget
{
    Q_OBJECT

public:
    explicit FigureStrip(QWidget *parent = nullptr);

    //! \param widest the longest text to make room for \returns the number of the figure
    int addFigure(const QString &caption, const QString &widest, const QString &tip);
    //! \param alert drawn in the colour of problems
    void setFigure(int number, const QString &text, bool alert = false);
    const QString &figure(int number) const { return mFigures[number].text; }
    bool isAlert(int number) const { return mFigures[number].alert; }
    //! How many figures there is room for.
    int visibleCount() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    struct Figure
    {
        QString caption, widest, tip, text;
        bool alert = false;
    };

    int widthOf(const Figure &figure) const;
    //! The number of the figure at a place; -1 for none.
    int figureAt(int x) const;

    std::vector<Figure> mFigures;
};

} // namespace autocuts
