// The action that transfers UVs from elsewhere.
#pragma once

#include "jobs/transferchoice.h"
#include "views/control/session/studiocontext.h"

#include <QObject>

namespace autocuts {

class Document;
class Questions;

//! Asks where the UVs are to come from, and starts the job.
class TransferActions final : public QObject
{
    Q_OBJECT

public:
    TransferActions(const StudioContext &context, Questions &questions, QObject *parent = nullptr);

private:
    void ask(const Document &document);

    StudioContext mContext;
    Questions &mQuestions;
    jobs::TransferChoice mChoice; //!< the one last made
};

} // namespace autocuts
