// The actions that hide and show faces.
#pragma once

#include "views/control/session/studiocontext.h"

#include <QObject>

namespace autocuts {

//! Connects the actions of the View menu that hide faces.
class HideActions final : public QObject
{
    Q_OBJECT

public:
    explicit HideActions(const StudioContext &context, QObject *parent = nullptr);

private:
    void hide();
    void hideOthers();
    void showAll();

    StudioContext mContext;
};

} // namespace autocuts
