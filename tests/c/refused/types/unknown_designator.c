/* A designator for a member that is not there. */
struct point { int x, y; };
static struct point p = { .x = 1, .w = 2 }; // error: 'w'

int main(void)
{
    return p.x;
}
