/* A message is passed on through two functions, and a part was never set. */
#include <stdio.h>
struct message { int to, from, length; char text[16]; };
static int send(struct message m)
{
    return m.length > 10 ? 2 : 1; // error: uninitialised read
}
static int forward(struct message m) { m.to++; return send(m); }
int main(void)
{
    struct message m = PLANT(({ struct message n; n.to = 1; n.from = 2; n; }), {1});
    printf("%d\n", forward(m));
    return 0;
}
