// The Select menu.
#pragma once

#include "views/control/studiocontext.h"

#include "model/document/selection.h"

#include <QObject>

namespace autocuts {

//! Connects the actions of the Select menu to the document's selection.
class SelectActions final : public QObject
{
    Q_OBJECT

public:
    explicit SelectActions(const StudioContext &context, QObject *parent = nullptr);

private:
    //! Calls change(document, selection) on a copy of the selection and sets the result.
    template <typename Change>
    void connectChange(const char *id, Change change);
    void connectMode(const char *id, SelectionMode mode);
    void showMode();

    StudioContext mContext;
};

} // namespace autocuts
