/* System V termio.h. No descriptor is a terminal: ioctl fails with ENOTTY. */
#ifndef _TERMIO_H
#define _TERMIO_H

#include <sys/ioctl.h>
#include <termios.h>

#define NCC 8

struct termio {
    unsigned short c_iflag, c_oflag, c_cflag, c_lflag;
    unsigned char c_line;
    unsigned char c_cc[NCC];
};

#endif
