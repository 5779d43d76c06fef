/* A case label that is not constant. */
int main(int argc, char **argv)
{
    switch (argc) {
    case argc: return 1; // error: constant
    }
    return 0;
}
