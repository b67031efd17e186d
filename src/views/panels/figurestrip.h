// A line of captions and figures at fixed positions.
#pragma once

#include <QString>
#include <QWidget>

#include <limits>
#include <span>
#include <vector>

namespace autocuts {

//! Every figure has enough space for its widest text, so that nothing moves while numbers change. When the
//! strip is too narrow, the figures added last are hidden.
class FigureStrip final : public QWidget
{
    Q_OBJECT

public:
    explicit FigureStrip(QWidget *parent = nullptr);

    //! \param widest longest text that has to fit \returns the index of the figure
    int addFigure(const QString &caption, const QString &widest, const QString &tip);
    //! \param alert true: draw it in the colour of problems
    void setFigure(int number, const QString &text, bool alert = false);
    //! Shows only so many figures, the first ones; all at first.
    void setShownCount(int count);
    const QString &figure(int number) const { return mFigures[number].text; }
    bool isAlert(int number) const { return mFigures[number].alert; }
    //! The number of shown figures that fit.
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

    std::span<const Figure> shown() const;
    int widthOf(const Figure &figure) const;
    //! The index of the figure at a position; -1 for none.
    int figureAt(int x) const;

    std::vector<Figure> mFigures;
    int mShown = std::numeric_limits<int>::max();
};

} // namespace autocuts
