/* Two default labels. */
int main(int argc, char **argv)
{
    switch (argc) {
    default: return 1;
    case 2: return 2;
    default: return 3; // error: default
    }
}
