/* A member of a struct that is only declared. */
struct unknown;

static int value(struct unknown *u)
{
    return u->value; // error: incomplete
}

int main(void)
{
    return value(0);
}
