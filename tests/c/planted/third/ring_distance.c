/* How far a reader of a ring buffer is behind, computed from the wrong buffer. */
#include <stdio.h>
struct ring { char data[40]; char *read, *write; };
static struct ring in, out;
static int behind(const struct ring *r) { return r->write - r->read; } // error: unrelated pointers
int main(void)
{
    in.read = in.data + 3;
    in.write = PLANT(out.data, in.data) + 9;
    printf("%d\n", behind(&in) != 0);
    return 0;
}
