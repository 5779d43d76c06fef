/* The missing value has gone through an array. */
int main(int argc, char **argv)
{
    int first, row[3], i = argc;

    if (argc > 5)
        first = 1;
    row[i] = first;
    return row[i]; // error: uninitialised read
}
