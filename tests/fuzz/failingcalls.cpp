// A library to preload into a program: one of its calls on files fails, or the program is killed at it.
//
// Environment: FAILING_FOLDER: only calls on files in this folder count. FAILING_LOG: a file that gets a line
// for each of them. FAILING_CALL: the number of the call that fails, from 1. FAILING_WITH: the number of the
// error (errno), or "kill". Calls that take relative paths count if the program runs in the folder.
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

const char *setting(const char *name)
{
    const char *value = std::getenv(name);
    return value ? value : "";
}

bool isInFolder(const char *path)
{
    const char *folder = setting("FAILING_FOLDER");
    const std::size_t length = std::strlen(folder);
    if (length == 0 || !path)
        return false;
    std::array<char, PATH_MAX> here{};
    if (path[0] != '/')
        path = getcwd(here.data(), here.size());
    return path && std::strncmp(path, folder, length) == 0 && (path[length] == '/' || path[length] == 0);
}

bool isInFolder(int file)
{
    std::array<char, 64> link{};
    std::array<char, PATH_MAX> path{};
    std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", file);
    // What is no file, such as a pipe, has no path: "pipe:[5]".
    return readlink(link.data(), path.data(), path.size() - 1) > 0 && path[0] == '/' &&
           isInFolder(path.data());
}

void log(const char *call)
{
    // By system calls, because the functions are replaced here.
    const long file = syscall(SYS_openat, AT_FDCWD, setting("FAILING_LOG"),
                              O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file < 0)
        return;
    std::array<char, 32> line{};
    const int length = std::snprintf(line.data(), line.size(), "%s\n", call);
    syscall(SYS_write, file, line.data(), length);
    syscall(SYS_close, file);
}

//! Counts a call. \returns true when it is the one that fails; errno is set then
bool fails(bool counts, const char *call)
{
    static std::atomic<int> calls = 0;
    if (!counts)
        return false;
    log(call);
    if (++calls != std::atoi(setting("FAILING_CALL")))
        return false;
    if (std::strcmp(setting("FAILING_WITH"), "kill") == 0)
        raise(SIGKILL);
    errno = std::atoi(setting("FAILING_WITH"));
    return true;
}

template <class Function>
Function original(const char *name, Function)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

//! The mode that an open with these flags has as a further argument.
mode_t modeOf(int flags, va_list arguments)
{
    return flags & (O_CREAT | __O_TMPFILE) ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

} // namespace

#define ORIGINAL(name) static const auto real = original(#name, name)
#define OPEN(name)                                                                                           \
    int name(const char *path, int flags, ...)                                                               \
    {                                                                                                        \
        ORIGINAL(name);                                                                                      \
        va_list arguments;                                                                                   \
        va_start(arguments, flags);                                                                          \
        const mode_t mode = modeOf(flags, arguments);                                                        \
        va_end(arguments);                                                                                   \
        return fails(isInFolder(path), #name) ? -1 : real(path, flags, mode);                                \
    }
#define OPENAT(name)                                                                                         \
    int name(int folder, const char *path, int flags, ...)                                                   \
    {                                                                                                        \
        ORIGINAL(name);                                                                                      \
        va_list arguments;                                                                                   \
        va_start(arguments, flags);                                                                          \
        const mode_t mode = modeOf(flags, arguments);                                                        \
        va_end(arguments);                                                                                   \
        return fails(isInFolder(path), #name) ? -1 : real(folder, path, flags, mode);                        \
    }

extern "C" {

OPEN(open)
OPEN(open64)
OPENAT(openat)
OPENAT(openat64)

ssize_t write(int file, const void *bytes, size_t count)
{
    ORIGINAL(write);
    return fails(isInFolder(file), "write") ? -1 : real(file, bytes, count);
}

int fsync(int file)
{
    ORIGINAL(fsync);
    return fails(isInFolder(file), "fsync") ? -1 : real(file);
}

int close(int file)
{
    ORIGINAL(close);
    const bool failed = fails(isInFolder(file), "close");
    const int error = errno, result = real(file); // a close that fails closes all the same
    errno = failed ? error : errno;
    return failed ? -1 : result;
}

int fchmod(int file, mode_t mode) noexcept
{
    ORIGINAL(fchmod);
    return fails(isInFolder(file), "fchmod") ? -1 : real(file, mode);
}

int rename(const char *from, const char *to) noexcept
{
    ORIGINAL(rename);
    return fails(isInFolder(to), "rename") ? -1 : real(from, to);
}

int link(const char *from, const char *to) noexcept
{
    ORIGINAL(link);
    return fails(isInFolder(to), "link") ? -1 : real(from, to);
}

int linkat(int fromFolder, const char *from, int toFolder, const char *to, int flags) noexcept
{
    ORIGINAL(linkat);
    return fails(isInFolder(to), "linkat") ? -1 : real(fromFolder, from, toFolder, to, flags);
}

int mkdir(const char *path, mode_t mode) noexcept
{
    ORIGINAL(mkdir);
    return fails(isInFolder(path), "mkdir") ? -1 : real(path, mode);
}

} // extern "C"
