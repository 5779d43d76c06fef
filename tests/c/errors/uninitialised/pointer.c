/* A pointer that points nowhere in particular. */
int main(void)
{
    int *p;

    *p = 1; // error: uninitialised read
    return 0;
}
