/* A _Bool cast is 0 or 1 wherever it is stored, however narrow the object. */
#include <stdio.h>

static unsigned char c;
static signed char s;
static short h;
static struct { unsigned char low; char list[2]; } t;
static int n = 256, m = 6;

static unsigned char narrow(int v)
{
    unsigned char local = (_Bool) v, *p = &local;

    return *p;
}

int main(void)
{
    unsigned char v[2] = { (_Bool) n, (_Bool) (m & 6) };
    int i;

    c = (_Bool) n;
    s = (_Bool) (n ^ m);
    h = (_Bool) (n << 8);
    i = (_Bool) n;
    t.low = (_Bool) (m << 4);
    t.list[1] = (signed char) (_Bool) (n * 2);
    printf("%d %d %d %d %d %d\n", c, s, h, i, t.low, t.list[1]);
    printf("%d %d %d %d\n", v[0], v[1], narrow(512), narrow(0));
    c = (_Bool) 0.25 + (_Bool) &n;
    printf("%d\n", c);
    return 0;
}
