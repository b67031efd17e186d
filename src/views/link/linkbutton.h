// Shows in the status bar which programs are linked.
#pragma once

#include <QToolButton>

namespace autocuts {

class LinkController;

//! Hidden while no program is linked. Its menu sends the map at once and ends the link.
class LinkButton final : public QToolButton
{
    Q_OBJECT

public:
    explicit LinkButton(LinkController &link, QWidget *parent = nullptr);

private:
    void showPrograms();

    LinkController &mLink;
};

} // namespace autocuts
