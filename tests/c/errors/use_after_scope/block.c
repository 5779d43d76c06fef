/* A pointer outlives the block of its variable. */
int main(void)
{
    int *p;

    {
        int inner = 3;
        p = &inner;
    }
    return *p; // error: use after scope
}
