#pragma once
#include <stdexcept>
#include <string>

namespace sphonic::driver {

/// A job stopped where a signal asked it to; `what` says where.
class Interruption : public std::runtime_error {
public:
    Interruption(int signal, const std::string& what) : std::runtime_error(what), signal_(signal) {}
    /// As shells count it.
    int exit_code() const { return 128 + signal_; }

private:
    int signal_;
};

/// While it lives, a signal that ends programs is only noted, so that the job can stop where it can clear up behind
/// itself. The third ends it at once (`timeout` sends two). A file that grows past the limit of its size is an error like a full disk.
class Interruptible {
public:
    Interruptible();
    ~Interruptible();
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;

    /// Throws an Interruption if a signal has come.
    void stop_if_asked(const std::string& place, const std::string& state) const;
};

}    // namespace sphonic::driver
