// A running autocuts-reader, and what is read from it. The only file that starts it.
#pragma once

#include <QtGlobal>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace autocuts {

//! How a reader ended.
struct ReaderEnd
{
    std::optional<int> code; //!< nothing: by a signal, such as that of a crash
    bool tookTooLong = false;
};

//! Starts the reader. It is ended and waited for at the latest by the destructor.
class ReaderProcess
{
public:
    //! \param command the program and its arguments, in the encoding of the system; an empty program starts
    //! nothing
    explicit ReaderProcess(std::vector<std::string> command);
    ~ReaderProcess();
    ReaderProcess(const ReaderProcess &) = delete;
    ReaderProcess &operator=(const ReaderProcess &) = delete;

    bool started() const;
    //! Appends what the reader has written to the bytes, after a short while at most. False at the end.
    bool read(std::vector<char> &bytes);
    //! Kills the reader unless it has ended.
    ReaderEnd end();

private:
    struct Process;
    std::unique_ptr<Process> mProcess; //!< null unless it runs
};

} // namespace autocuts
