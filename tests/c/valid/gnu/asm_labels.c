/* Objects and functions with assembler names, as used by headers. */
#include <stdio.h>

int speed asm("fastest") = 40;
extern int same __asm__("fast" "est");

int old(int x) __asm__("drive_v1");
int old(int x) { return x + 1; }

int new_(int x) __asm__("drive_v2"), unused_ __asm__("nowhere");
int new_(int x) { return x + 2; }

int drive_v1(int x);
extern int print(const char *format, ...) __asm("printf") __attribute__((format(printf, 1, 2)));

int later(int x);
static int early(void) { return later(1); }
int later(int x) __asm__("renamed_afterwards");
int later(int x) { return x * 10; }

int main(void)
{
    extern int fastest;
    extern int inner(int) asm("drive_v2");

    same += 2;
    print("%d %d\n", speed, fastest);
    print("%d %d %d\n", old(10), new_(10), inner(20));
    printf("%d\n", early());
    return 0;
}
