/* A member that nobody set is passed by value, twice. */
struct pose { int x, y, heading; };

static int is_turned(struct pose p)
{
    return p.heading > 90; // error: uninitialised read
}

static int moved(struct pose p)
{
    p.x++;
    return is_turned(p);
}

int main(void)
{
    struct pose p;

    p.x = p.y = 0;
    return moved(p);
}
