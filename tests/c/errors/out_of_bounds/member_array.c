/* Behind the last member of a struct. */
struct ring { int head; int order[16]; };
static struct ring ring;

int main(void)
{
    volatile int i = 16;

    return ring.order[i]; // error: out of bounds
}
