/* Terminal settings as drivers of the 1980s and 1990s name them; no descriptor is a terminal. */
// without gcc: the headers of Linux know nothing of sgtty.h
#include <fcntl.h>
#include <glob.h>
#include <linux/types.h>
#include <sgtty.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <termio.h>
#include <termios.h>

static const int speeds[] = { B50, B75, B110, B134, B150, B200, B300, B600, B1200, B1800,
    B2400, B4800, B9600, EXTA, EXTB, B57600, B115200 };

int main(void) {
    struct sgttyb old = { B9600, B9600, 010, 025, RAW | CBREAK };
    struct termio system_v = { IGNPAR | IUCLC, OPOST | OLCUC | NL1 | CR2 | TAB3, CS7 | PARENB };
    struct termios posix;
    glob_t found;
    int sum = 0, bits = TIOCM_DTR | TIOCM_RTS;
    for (int i = 0; i < (int) (sizeof speeds / sizeof speeds[0]); i++) sum += speeds[i];
    printf("%d %o %o\n", sum, NLDLY | CRDLY | TABDLY | BSDLY | VTDLY | FFDLY, XTABS);
    printf("%d %d %d\n", gtty(0, &old), stty(0, &old), ioctl(0, TIOCSETP, &old));
    printf("%d %d\n", ioctl(0, TCSETAW, &system_v), ioctl(0, TCGETS, &posix));
    printf("%d %d\n", ioctl(0, TIOCMBIS, &bits), ioctl(0, TIOCEXCL, 0));
    printf("%d\n", tcgetattr(0, &posix));
    printf("%d\n", FASYNC);
    printf("%d", glob("nothing*", 0, NULL, &found) == GLOB_NOMATCH);
    globfree(&found);
    puts(" freed");
    return 0;
}
