/* A number that happens to lie in memory. */
int main(void)
{
    int *p = (int *) 0xA00000;

    *p = 1; // error: wild pointer
    return 0;
}
