/* Terminals and devices (POSIX termios.h, ioctl): no descriptor is one. */
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <sgtty.h>

#include <crs/descriptor.h>

static int no_terminal(int descriptor)
{
    if (__crs_find(descriptor) != 0)
        errno = ENOTTY;
    return -1;
}

int tcgetattr(int descriptor, struct termios *settings)
{
    (void)settings;
    return no_terminal(descriptor);
}

int tcsetattr(int descriptor, int when, const struct termios *settings)
{
    (void)when;
    (void)settings;
    return no_terminal(descriptor);
}

int tcflush(int descriptor, int which)
{
    (void)which;
    return no_terminal(descriptor);
}

int tcdrain(int descriptor)
{
    return no_terminal(descriptor);
}

int tcflow(int descriptor, int action)
{
    (void)action;
    return no_terminal(descriptor);
}

int gtty(int descriptor, struct sgttyb *settings)
{
    (void)settings;
    return no_terminal(descriptor);
}

int stty(int descriptor, const struct sgttyb *settings)
{
    (void)settings;
    return no_terminal(descriptor);
}

int tcsendbreak(int descriptor, int duration)
{
    (void)duration;
    return no_terminal(descriptor);
}

/* Returns the number of bytes that can be read: the rest of a file, or of a line of the input. */
static int waiting_bytes(struct __crs_open_file *file, int descriptor)
{
    double wait_s;
    long left;

    if (file->operations != 0)
        return file->operations->available(file);
    if (file->number < 0)
        return (file->flags & O_ACCMODE) == O_RDONLY ? __crs_input(&wait_s) : 0;
    left = __crs_resize(descriptor, -1) - file->offset;
    return left > 0 ? left : 0;
}

int ioctl(int descriptor, unsigned long request, ...)
{
    struct __crs_open_file *file = __crs_find(descriptor);
    va_list arguments;
    int *argument;

    if (file == 0)
        return -1;
    if (request != FIONREAD && request != FIONBIO)
        return no_terminal(descriptor);
    va_start(arguments, request);
    argument = va_arg(arguments, int *);
    va_end(arguments);
    if (request == FIONREAD)
        *argument = waiting_bytes(file, descriptor);
    else
        file->flags = (file->flags & ~O_NONBLOCK) | (*argument ? O_NONBLOCK : 0);
    return 0;
}

int cfsetispeed(struct termios *settings, speed_t speed)
{
    settings->c_ispeed = speed;
    return 0;
}

int cfsetospeed(struct termios *settings, speed_t speed)
{
    settings->c_ospeed = speed;
    return 0;
}

speed_t cfgetispeed(const struct termios *settings)
{
    return settings->c_ispeed;
}

speed_t cfgetospeed(const struct termios *settings)
{
    return settings->c_ospeed;
}

void cfmakeraw(struct termios *settings)
{
    settings->c_iflag &= ~(IGNBRK | BRKINT | PARMRK | ISTRIP | INLCR | IGNCR | ICRNL | IXON);
    settings->c_oflag &= ~OPOST;
    settings->c_lflag &= ~(ECHO | ECHONL | ICANON | ISIG | IEXTEN);
    settings->c_cflag = (settings->c_cflag & ~(CSIZE | PARENB)) | CS8;
    settings->c_cc[VMIN] = 1;
    settings->c_cc[VTIME] = 0;
}
