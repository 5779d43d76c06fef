/* A switch without a default leaves the variable alone. */
static int cost(int kind)
{
    int c;

    switch (kind) {
    case 1: c = 5; break;
    case 2: c = 7; break;
    }
    return 3 * c; // error: uninitialised read
}

int main(void)
{
    return cost(2) + cost(3);
}
