// A part of a panel that can be folded away.
#pragma once

#include <QWidget>

class QToolButton;

namespace autocuts {

//! A heading with an arrow; a click shows or hides the content below it.
class FoldSection final : public QWidget
{
    Q_OBJECT

public:
    //! Begins folded. \param content becomes a child
    FoldSection(const QString &title, QWidget *content, QWidget *parent = nullptr);

    bool isOpen() const;
    void setOpen(bool open);

private:
    QToolButton *mHeading;
    QWidget *mContent;
};

} // namespace autocuts
