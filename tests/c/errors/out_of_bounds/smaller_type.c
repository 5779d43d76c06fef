/* A pointer to a char is used as one to a long long. */
int main(void)
{
    char c = 1;
    void *p = &c;

    return *(long long *) p > 0; // error: out of bounds
}
