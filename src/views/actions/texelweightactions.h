// The actions that set and clear the texel weights of faces.
#pragma once

#include "views/control/session/studiocontext.h"

#include <QObject>

namespace autocuts {

class Document;
class Questions;

//! Sets and clears texel weights; each is one undo entry, and a running live solve takes them up.
class TexelWeightActions final : public QObject
{
    Q_OBJECT

public:
    TexelWeightActions(const StudioContext &context, Questions &questions, QObject *parent = nullptr);

private:
    void ask(Document &document);

    StudioContext mContext;
    Questions &mQuestions;
    double mWeight = 2; //!< the value last chosen in the dialog
};

} // namespace autocuts
