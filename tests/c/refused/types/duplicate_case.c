/* The same case twice. */
int main(int argc, char **argv)
{
    switch (argc) {
    case 1: return 1;
    case 3 - 2: return 2; // error: duplicate
    }
    return 0;
}
