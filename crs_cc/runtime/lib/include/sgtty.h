/* BSD 4.3 sgtty.h. No descriptor is a terminal: gtty and stty fail with ENOTTY. */
#ifndef _SGTTY_H
#define _SGTTY_H

#include <sys/ioctl.h>

#include <crs/speeds.h>

struct sgttyb {
    char sg_ispeed, sg_ospeed, sg_erase, sg_kill;
    short sg_flags;
};

struct tchars {
    char t_intrc, t_quitc, t_startc, t_stopc, t_eofc, t_brkc;
};

#define TANDEM 0x0001
#define CBREAK 0x0002
#define LCASE 0x0004
#define ECHO 0000010
#define CRMOD 0x0010
#define RAW 0x0020
#define ODDP 0x0040
#define EVENP 0x0080
#define ANYP 0x00c0
#define XTABS 0014000

#define TIOCGETP 0x7408
#define TIOCSETP 0x7409
#define TIOCSETN 0x740a
#define TIOCFLUSH 0x7410
#define TIOCGETC 0x7412
#define TIOCSETC 0x7411

int gtty(int descriptor, struct sgttyb *settings);
int stty(int descriptor, const struct sgttyb *settings);

#endif
