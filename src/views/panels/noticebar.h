// A message that stays until it is read.
#pragma once

#include "model/document/selection.h"

#include <QFrame>

class QLabel;
class QToolButton;

namespace autocuts {

class Workspace;

//! A bar over the top of the views for what a job could not do. The views keep their places below it. It
//! stays until the user closes it, the next job ends or another model is opened. A click selects the items
//! that the message is about.
class NoticeBar final : public QFrame
{
    Q_OBJECT

public:
    explicit NoticeBar(Workspace &workspace, QWidget *parent = nullptr);

    //! \param message translated; empty: the bar disappears
    //! \param items what the message is about; empty: nothing can be selected
    void showNotice(const QString &message, const Selection &items = {});
    QString message() const;

Q_SIGNALS:
    //! The bar was moved, shown or hidden.
    void placed();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void selectItems();
    void place();

    Workspace &mWorkspace;
    QLabel *mText;
    QToolButton *mSelect, *mClose;
    Selection mItems;
};

} // namespace autocuts
