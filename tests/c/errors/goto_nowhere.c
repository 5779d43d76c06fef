/* A computed goto to an address that is not that of a label. */
int main(int argc, char **argv)
{
    void *table[] = {&&end, 0};

    goto *table[argc]; // error: invalid goto target
end:
    return 0;
}
