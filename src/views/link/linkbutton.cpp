#include "views/link/linkbutton.h"

#include "views/link/linkcontroller.h"

#include <QMenu>

namespace autocuts {

LinkButton::LinkButton(LinkController &link, QWidget *parent) : QToolButton(parent), mLink(link)
{
    setObjectName(QStringLiteral("link"));
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    setPopupMode(QToolButton::InstantPopup);
    setToolTip(tr("Programs that get this map while you work"));
    auto *menu = new QMenu(this);
    menu->addAction(tr("Send the map now"), &mLink, &LinkController::sendMap);
    menu->addAction(tr("End the link"), &mLink, &LinkController::endAll);
    setMenu(menu);
    connect(&mLink, &LinkController::changed, this, &LinkButton::showPrograms);
    showPrograms();
}

void LinkButton::showPrograms()
{
    QStringList names;
    for (const LinkClient *client : mLink.clients())
        names << client->name();
    setText(tr("Linked: %1").arg(names.join(QStringLiteral(", "))));
    setVisible(!names.isEmpty());
}

} // namespace autocuts
