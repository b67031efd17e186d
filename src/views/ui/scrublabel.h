// The caption of a number field; dragging it sideways changes the number.
#pragma once

#include <QLabel>

class QAbstractSpinBox;

namespace autocuts {

//! With Shift a drag changes the number ten times as fast, with Ctrl ten times as slowly.
class ScrubLabel final : public QLabel
{
    Q_OBJECT

public:
    //! \param field the spin box that a drag changes
    ScrubLabel(const QString &text, QAbstractSpinBox *field, QWidget *parent = nullptr);

    //! A number for the drag that is going on, so that all its steps can become one undo entry; 0 when there
    //! is none. No two drags have the same number.
    static quint64 gesture();

protected:
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    void step(double steps);

    QAbstractSpinBox *mField;
    double mLast = 0; //!< position of the mouse, logical pixels
    double mRest = 0; //!< steps that are not a whole one yet
    bool mScrubs = false;
};

//! The spin box that operates a field: itself, or the one that its focus goes to; null when there is none.
QAbstractSpinBox *spinBoxOf(QWidget *field);

} // namespace autocuts
