/* A member was forgotten. */
struct pose { int x, y, heading; };

static int sum(const struct pose *p)
{
    return p->x + p->y + p->heading; // error: uninitialised read
}

int main(void)
{
    struct pose p;

    p.x = p.y = 1;
    return sum(&p);
}
