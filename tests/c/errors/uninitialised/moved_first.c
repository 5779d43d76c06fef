/* The missing value has gone through another variable. */
int main(int argc, char **argv)
{
    int first, second;

    if (argc > 5)
        first = 1;
    second = first;
    return second * 2; // error: uninitialised read
}
